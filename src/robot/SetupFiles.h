#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "logs/RecordedSetup.h"
#include "robot/Processes.h"

namespace gt {

/// Where the files are that make a robot, and who it is.
struct SetupFiles {
  ConfigurationPaths paths;
  std::string layout;
  Player player;
  std::uint64_t seed = 0;
  std::string address{};  ///< Hardware address.
};

/// The task that needs the images' pixels.
constexpr std::string_view imageTask = "ImageProcessor";

/// Reads the files, so that a log can keep them.
Result<RecordedSetup> recordSetup(const SetupFiles& files);

/// Makes the setup of a robot of a recorded one, for a program with these solutions.
Result<RobotSetup> readSetup(const RecordedSetup& recorded, const RobotModules& modules);

/// What robots see in images, by name. A log without the images' pixels holds it.
std::vector<std::string> perceptsOfImages(const SolutionTable& table);

/// The commit from which this program was built, with -dirty behind it if the sources had changed;
/// empty if they were in no repository.
std::string commit();

}  // namespace gt
