#include "console/Console.h"

#include <algorithm>

#include "console/Commands.h"
#include "streams/File.h"

namespace gt {
namespace {

constexpr int deepest = 16;  // scripts that call scripts

}  // namespace

Result<Words> splitWords(std::string_view line) {
  Words words;
  std::size_t at = 0;
  while (true) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == line.npos) return words;
    if (line[at] == '"') {
      const std::size_t end = line.find('"', at + 1);
      if (end == line.npos) return Error{"", 0, "", "a quote is not closed"};
      words.emplace_back(line.substr(at + 1, end - at - 1));
      at = end + 1;
    } else {
      const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
      words.emplace_back(line.substr(at, end - at));
      at = end;
    }
  }
}

const std::vector<Command>& Console::commands() {
  static const std::vector<Command> table = [] {
    std::vector<Command> all = globalCommands();
    for (const Command& command : robotCommands()) all.push_back(command);
    return all;
  }();
  return table;
}

const Command* Console::find(std::string_view name) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == commands().end() ? nullptr : &*found;
}

Result<void> Console::execute(std::string_view line) {
  auto words = splitWords(line);
  if (!words) return words.error();
  if (words->empty() || words->front().starts_with('#')) return {};
  const Command* command = find(words->front());
  if (!command) return Error{"", 0, words->front(), "there is no such command; try help"};
  auto done = command->execute(*this, *words);
  if (!done && done.error().field.empty())
    return Error{done.error().file, done.error().line, words->front(), done.error().what};
  return done;
}

Result<void> Console::call(const std::string& path) {
  if (depth_ >= deepest) return Error{path, 0, "call", "scripts call each other too deeply"};
  const auto text = readFile(path);
  if (!text) return text.error();
  ++depth_;
  Result<void> done;
  int number = 0;
  for (std::size_t at = 0; at < text->size() && done; ++number) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    done = execute(std::string_view{*text}.substr(at, end - at));
    at = end + 1;
  }
  --depth_;
  // The error of a script that was called names its own place.
  if (!done && done.error().file.empty())
    return Error{path, number, done.error().field, done.error().what};
  return done;
}

std::vector<ConsoleWorld::NamedRobot> Console::selected() {
  std::vector<ConsoleWorld::NamedRobot> robots = world_.robots();
  if (!selected_.empty())
    std::erase_if(robots, [this](const ConsoleWorld::NamedRobot& robot) {
      return std::find(selected_.begin(), selected_.end(), robot.name) == selected_.end();
    });
  return robots;
}

Result<void> Console::forEachRobot(const std::function<Result<void>(Robot&)>& work) {
  for (const auto& [name, robot] : selected())
    if (const auto done = work(*robot); !done) {
      const Error& error = done.error();
      return Error{error.file, error.line, error.field, error.what + " (" + name + ")"};
    }
  return {};
}

}  // namespace gt
