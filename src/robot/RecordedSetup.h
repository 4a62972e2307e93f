#pragma once
#include <string>

#include "robot/Processes.h"
#include "streams/Mcap.h"

namespace gt {

/// What makes a robot, as files: a log keeps it, so that a replay needs nothing but the log.
struct RecordedSetup {
  ConfigurationPaths paths;
  std::string layout;
  Player player;
  std::uint64_t seed = 0;
  std::string address{};  ///< Hardware address.
};

/// Puts it into a log: the files of configuration, motions and behavior and the layout as
/// attachments; who the robot is, its seed and the program's commit as metadata.
Result<void> attachSetup(const RecordedSetup& setup, McapWriter& log);

/// Makes a setup of what a log holds, for a program with these solutions. An error if it does not
/// hold all of it.
Result<RobotSetup> readSetup(const McapReader& log, const std::string& file,
                             const RobotModules& modules);

/// The commit from which this program was built, with -dirty behind it if the sources had changed;
/// empty if they were in no repository.
std::string commit();

}  // namespace gt
