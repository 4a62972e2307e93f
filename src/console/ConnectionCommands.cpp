#include <filesystem>

#include "console/Commands.h"

namespace gt {
namespace {

Result<void> sc(Console& console, const Words& words) {
  const bool gameManager = words.size() > 1 && words[1] == "gameManager";
  const std::vector<std::string> robots{words.begin() + (gameManager ? 2 : 1), words.end()};
  if (robots.empty()) return wrongArguments(words);
  return console.session().connect(robots, gameManager);
}

Result<void> sl(Console& console, const Words& words) {
  const bool there = std::filesystem::is_regular_file(words[2]);
  const std::string file = there ? words[2] : withDefaults(words[2], "out/logs", ".mcap");
  return console.session().replay(words[1], file, words.size() == 4 ? words[3] : "");
}

std::vector<std::string> robotNames(Console& console, const Words&) {
  std::vector<std::string> names;
  for (const auto& robot : console.session().robots()) names.push_back(robot->name());
  return names;
}

Result<void> selectRobots(Console& console, const Words& words) {
  if (words[1] == "all") {
    console.select({});
    return {};
  }
  if (words[1] == "?") {
    for (const auto& known : console.session().robots()) console.print(known->name());
    return {};
  }
  for (std::size_t i = 1; i < words.size(); ++i)
    if (!console.session().find(words[i]))
      return Error{.field = words[i],
                   .what = "there is no robot of that name; try robot ?" +
                           suggestion(words[i], robotNames(console, words))};
  console.select({words.begin() + 1, words.end()});
  return {};
}

}  // namespace

std::vector<Command> connectionCommands() {
  using enum Command::Kind;
  return {
      {global, "robot", "? | all | ROBOT {ROBOT}",
       "Selects the robots that the robot commands are for, or lists them.", selectRobots,
       robotNames, true},
      {initialization, "sc",
       "[gameManager] (A.B.C.D | A.B.C D {D} | NAME=ENDPOINT {NAME=ENDPOINT})",
       "Connects to robots elsewhere, through a router that runs in the background; with "
       "gameManager "
       "it has a port for one. To be used once. A robot is named by the last number of its "
       "address.",
       sc},
      {initialization, "sl", "NAME LOG [COLORTABLE]",
       "Creates a robot of that name whose inputs come from a log, in out/logs/ and with .mcap if "
       "the file has no folder and extension; logs of real robots of 2009 may name a color table. "
       "With st on, which is the default, no image is lost.",
       sl}};
}

}  // namespace gt
