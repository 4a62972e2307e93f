#pragma once
#include <optional>
#include <string>

#include "network/Keys.h"
#include "network/RobotAddresses.h"
#include "robot/Processes.h"
#include "robot/Solutions.h"

namespace gt {

/// Options of a program that is one process of a robot.
struct RobotProgramOptions {
  std::string process;  ///< Name of the process in the layout.
  std::string layout = "layouts/cmd.layout";
  Player player;
  std::string hardwareAddress;  ///< Identifies the robot in robot.cfg.
  std::uint64_t seed = 1;
  ConfigurationPaths paths;
  RobotAddresses addresses;
  std::optional<Keys> listenKeys, connectKeys;  ///< For endpoints that are reached via the network.
  std::string logs;   ///< Folder in which the Debug process records a log; none if empty.
  std::string tools;  ///< Endpoint on which the Debug process listens for tools; empty: that of the
                      ///< process "Tools".
};

/// Runs one process of a robot as a program of its own (report 2.2.4) until a signal ends it
/// (EndSignals). `modules` are those that are linked into the program, at least those of the
/// process; only the configuration that they need is read. The packages that are exchanged with the
/// robot's other processes and the platform follow from the layout. Returns errors at the start.
/// Programs that are awaited or cannot be understood are reported on stderr.
Result<void> runRobotProgram(const RobotProgramOptions& options, const RobotModules& modules);

}  // namespace gt
