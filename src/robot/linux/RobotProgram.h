#pragma once
#include <optional>
#include <string>

#include "network/Keys.h"
#include "network/RobotAddresses.h"
#include "robot/Processes.h"
#include "robot/Solutions.h"

namespace gt {

/// What a program that is one process of a robot is started with.
struct RobotProgramOptions {
  std::string process;  ///< Its name in the layout.
  std::string layout = "layouts/cmd.layout";
  Player player;
  std::string hardwareAddress;  ///< By which robot.cfg knows the robot.
  std::uint64_t seed = 1;
  ConfigurationPaths paths;
  RobotAddresses addresses;
  std::optional<Keys> listenKeys, connectKeys;  ///< For endpoints that are reached by network.
  std::string logs;   ///< Folder in which the Debug process records a log; none if empty.
  std::string tools;  ///< Where the Debug process listens for tools; empty: as its process "Tools".
};

/// Runs one process of a robot as a program of its own (report 2.2.4) until it is told to end
/// (EndSignals). `modules` are those that are linked into the program: at least those of the
/// process; only the configuration that they need is read. What it reads from and sends to the
/// robot's other processes and the platform follows from the layout. Errors are those of a wrong
/// start; whom it waits for and cannot understand is printed on stderr.
Result<void> runRobotProgram(const RobotProgramOptions& options, const RobotModules& modules);

}  // namespace gt
