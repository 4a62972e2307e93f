#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "logs/RecordedSetup.h"
#include "robot/Processes.h"

namespace gt {

/// The files from which a robot is made, and its identity.
struct SetupFiles {
  ConfigurationPaths paths;
  std::string layout;
  Player player;
  std::uint64_t seed = 0;
  std::string address{};  ///< Hardware address.
};

/// Name of the task that reads the images' pixels.
constexpr std::string_view imageTask = "ImageProcessor";

/// Reads the files into a form that can be stored in a log.
Result<RecordedSetup> recordSetup(const SetupFiles& files);

/// Makes a robot's setup from a recorded one, for a program with these solutions.
Result<RobotSetup> readSetup(const RecordedSetup& recorded, const RobotModules& modules);

/// Names of the representations that are computed from images. A log without the images' pixels
/// contains them.
std::vector<std::string> perceptsOfImages(const SolutionTable& table);

/// The commit from which this program was built, followed by -dirty if the sources had changed;
/// empty if they were not in a repository.
std::string commit();

}  // namespace gt
