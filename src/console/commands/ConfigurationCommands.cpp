#include <filesystem>

#include "base/Lines.h"
#include "console/Commands.h"
#include "observer/robots/RunningConfiguration.h"
#include "robot/Deployment.h"

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

/// Copies the configuration of this session for a robot's own programs.
Result<void> deployTo(Console& console, const Words& words) {
  const ConfigurationFiles& files = console.session().match().configuration().files;
  const Deployment deployment{
      .config = files.paths.config,
      .location = files.paths.location,
      .player = {*enumValue<TeamColor>(words[2]), *enumValue<PlayerRole>(words[3])},
      .robot = words[1],
      .endpoint = words.size() > 5 ? words[5] : ""};
  const auto there = deploy(deployment, words[4]);
  if (!there) return there.error();
  console.print(words[4] + " holds the configuration with:");
  for (const Line& line : linesOf(*there)) console.print("  " + std::string{line.text});
  return {};
}

}  // namespace

std::vector<Command> configurationCommands() {
  return {
      {Command::Kind::robot, "config", "(save | load) FOLDER",
       "Writes what a robot works with now, or has it work with what was written: solutions, "
       "parameters, color table or the HSI ranges it was made of, TSL thresholds, settings of the "
       "camera, calibration, dimensions. The folder lies in "
       "out/configs/ if it is named without a path; a robot can be started with it, too.",
       config, nullptr, true},
      {Command::Kind::global, "deploy",
       "NAME (red | blue) (goalie | defender | striker1 | striker2) TARGET "
       "[ENDPOINT]",
       "Copies the configuration with the name, team color and role of a robot to where its "
       "programs read it: to a folder, such as a memory stick, or by ssh to HOST:FOLDER. Tools "
       "will connect at "
       "the endpoint, such as tcp://0.0.0.0:15000. Prints what is there then.",
       deployTo}};
}

}  // namespace gt
