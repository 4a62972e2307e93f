#include <charconv>
#include <cmath>

#include "console/Commands.h"
#include "streams/File.h"

namespace gt {
namespace {

std::string rest(const Words& words) {
  std::string text;
  for (std::size_t i = 1; i < words.size(); ++i) text += (i > 1 ? " " : "") + words[i];
  return text;
}

Result<void> help(Console& console, const Words& words) {
  for (const Command& command : Console::commands()) {
    if (words.size() > 1 && command.name != words[1]) continue;
    std::string usage{command.name};
    if (!command.arguments.empty()) usage += " " + std::string{command.arguments};
    console.world().print(usage);
    console.world().print("    " + std::string{command.help});
  }
  if (words.size() > 1 && !Console::find(words[1]))
    return Error{"", 0, words[1], "there is no such command"};
  return {};
}

Result<void> echo(Console& console, const Words& words) {
  console.world().print(rest(words));
  return {};
}

Result<void> call(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  return console.call(words[1]);
}

Result<void> selectRobots(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  if (words[1] == "all") {
    console.select({});
    return {};
  }
  const auto robots = console.world().robots();
  if (words[1] == "?") {
    for (const auto& robot : robots) console.world().print(robot.name);
    return {};
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    bool known = false;
    for (const auto& robot : robots) known |= robot.name == words[i];
    if (!known) return Error{"", 0, words[i], "there is no robot of that name; try robot ?"};
  }
  console.select({words.begin() + 1, words.end()});
  return {};
}

Result<void> run(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const auto seconds = numberOf(words[1]);
  if (!seconds) return seconds.error();
  if (!(*seconds >= 0 && *seconds < 1e6)) return wrongArguments(words);
  const Time end = console.world().time() + std::llround(1000 * *seconds);
  while (console.world().time() < end && console.world().step()) {
  }
  return {};
}

}  // namespace

Result<double> numberOf(const std::string& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(number))
    return Error{"", 0, word, "is no number"};
  return number;
}

Error wrongArguments(const Words& words) {
  const Command* command = Console::find(words.front());
  return {"", 0, words.front(),
          "expected: " + words.front() + " " + std::string{command ? command->arguments : ""}};
}

std::vector<Command> globalCommands() {
  using enum Command::Kind;
  return {{global, "call", "FILE", "Executes a script, one command per line.", call},
          {global, "echo", "TEXT", "Prints a text.", echo},
          {global, "help", "[COMMAND]", "Tells what there is.", help},
          {global, "?", "[COMMAND]", "The same as help.", help},
          {global, "robot", "? | all | NAME {NAME}",
           "Selects the robots that the robot commands are for, or lists them.", selectRobots},
          {global, "run", "SECONDS", "Lets simulated time pass.", run}};
}

}  // namespace gt
