#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "base/Suggestion.h"
#include "console/Commands.h"
#include "observer/MessageQueues.h"

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

/// A word behind `to` or `from`: physicalRobot behind `to` is toPhysicalRobot.
std::optional<QueueName> queueOf(const std::string& direction, std::string word) {
  if (word.empty()) return std::nullopt;
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  return enumValue<QueueName>(direction + word);
}

/// The robots of a queue; the selected ones come first, so that they are the connected ones.
std::vector<std::string> robotsOf(Console& console, QueueName queue) {
  std::vector<ObservedRobot*> robots;
  const auto selected = console.selected();
  for (ConsoleRobot* robot : selected) robots.push_back(&robot->observed());
  for (const auto& robot : console.session().robots())
    if (std::ranges::find(selected, robot.get()) == selected.end())
      robots.push_back(&robot->observed());
  std::vector<std::string> names;
  for (const ObservedRobot* robot : gt::robotsOf(queue, robots)) names.push_back(robot->name());
  return names;
}

/// to and from: a robot command for the robots of a message queue, independent of the selection.
Result<void> withQueue(Console& console, const Words& words) {
  const auto queue = queueOf(words[0], words[1]);
  const Command* command = Console::find(words[2]);
  if (!queue || !command) return wrongArguments(words);
  if (command->kind != Command::Kind::robot)
    return Error{.field = words[2], .what = "is no command for selected robots"};
  const std::vector<std::string> names = robotsOf(console, *queue);
  if (names.empty()) return Error{.field = words[1], .what = "there is no such robot"};
  return console.executeFor(names, words.rest.substr(words.rest.find(words[2], words[1].size())));
}

}  // namespace

std::vector<Command> connectionCommands() {
  using enum Command::Kind;
  return {
      {global, "robot", "? | all | ROBOT {ROBOT}",
       "Selects the robots that the robot commands are for, or lists them.", selectRobots,
       robotNames, true},
      {global, "from", "(physicalRobot | simulatedRobot) COMMAND",
       "Executes a robot command for the robot from which a queue comes (report 5.2): the "
       "connected "
       "one elsewhere, or of the simulator, which is the first that is selected or that there is. "
       "So from physicalRobot log start records what that robot sends.",
       withQueue},
      {global, "to",
       "(physicalRobot | allPhysicalRobots | simulatedRobot | allSimulatedRobots) COMMAND",
       "Executes a robot command for the robots to which a queue leads (report 5.2): the connected "
       "one of a kind, or all of them, whatever robots are selected.",
       withQueue},
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
       "With st on, which is the default, no image is lost. What of the log is damaged is printed. "
       "Logs that have not been played yet begin in step: the later one waits. The robot has no "
       "body "
       "in the scene: of its name there must be none yet, and what it truly does is unknown.",
       sl}};
}

}  // namespace gt
