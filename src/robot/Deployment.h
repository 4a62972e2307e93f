#pragma once
#include <string>

#include "representations/infrastructure/Player.h"
#include "robot/ConfigFolder.h"

namespace gt {

/// What a robot's own programs read when they start, for one robot (report J.2.5: cp,
/// copyfiles.bash).
struct Deployment {
  std::string config;      ///< The folder of configuration files that is copied.
  std::string location{};  ///< Written to location.cfg, if not empty.
  Player player;           ///< Written to player.cfg.
  std::string robot;       ///< Its name, written to network.cfg,
  std::string endpoint{};  ///< as is where tools connect, if not empty.
};

/// Copies a robot's configuration to a folder, such as a memory stick, or by ssh to HOST:FOLDER,
/// where no password may be needed. Files of other names that are there stay. Returns the
/// player.cfg and network.cfg that are there then.
Result<std::string> deploy(const Deployment& deployment, const std::string& target);

}  // namespace gt
