#pragma once
#include <string>

#include "representations/infrastructure/Player.h"
#include "robot/ConfigFolder.h"

namespace gt {

/// The files that a robot's own programs read when they start, for one robot (report J.2.5: cp,
/// copyfiles.bash).
struct Deployment {
  std::string config;      ///< The folder of configuration files that is copied.
  std::string location{};  ///< Written to location.cfg, if not empty.
  Player player;           ///< Written to player.cfg.
  std::string robot;       ///< Name of the robot, written to network.cfg.
  std::string endpoint{};  ///< Endpoint for tools, written to network.cfg, if not empty.
};

/// Copies a robot's configuration to a folder, such as a memory stick, or by ssh to HOST:FOLDER,
/// which must not require a password. Other files in the target folder are kept. Returns the
/// content of player.cfg and network.cfg in the target.
Result<std::string> deploy(const Deployment& deployment, const std::string& target);

}  // namespace gt
