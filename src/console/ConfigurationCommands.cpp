#include <filesystem>

#include "console/Commands.h"
#include "robot/RunningConfiguration.h"

namespace gt {
namespace {

Result<void> config(Console& console, const Words& words) {
  namespace fs = std::filesystem;
  const bool several = console.selected().size() > 1 && words[1] == "save";
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    const fs::path named{words[2]};
    const fs::path folder = named.has_parent_path() ? named : fs::path{"out/configs"} / named;
    if (words[1] == "load")
      return loadRunningConfiguration(robot.observed(), folder.string(),
                                      console.session().options().root);
    const std::string own = (several ? folder / robot.name() : folder).string();
    if (auto done = saveRunningConfiguration(robot.observed(), own); !done) return done;
    printWritten(console, own);
    return {};
  });
}

}  // namespace

std::vector<Command> configurationCommands() {
  return {
      {Command::Kind::robot, "config", "(save | load) FOLDER",
       "Writes what a robot works with now, or has it work with what was written: solutions, "
       "parameters, color table or the HSI ranges it was made of, TSL thresholds, settings of the "
       "camera, calibration, dimensions. The folder lies in "
       "out/configs/ if it is named without a path; a robot can be started with it, too.",
       config, nullptr, true}};
}

}  // namespace gt
