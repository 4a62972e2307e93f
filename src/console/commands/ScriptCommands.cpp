#include "base/Suggestion.h"
#include "console/Commands.h"

namespace gt {
namespace {

constexpr std::size_t lineWidth = 100;

/// Prints a text in lines that are not too long, the first after `begin`, all others indented.
void printWrapped(Console& console, std::string begin, std::string_view text, std::size_t indent) {
  std::string line = std::move(begin);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (line.size() + 1 + end > lineWidth && line.size() > indent) {
      console.print(line);
      line.assign(indent, ' ');
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
    line += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  console.print(line);
}

void printHelp(Console& console, const Command& command) {
  printWrapped(console, std::string{command.name}, command.arguments, 8);
  printWrapped(console, "    ", command.help, 4);
}

/// The topics, with the names of their commands.
void printTopics(Console& console) {
  std::size_t widest = 0;
  for (const HelpTopic& topic : topics()) widest = std::max(widest, topic.name.size());
  for (const HelpTopic& topic : topics()) {
    std::string begin{topic.name};
    begin.resize(widest + 2, ' ');
    std::string names;
    for (const Command& command : Console::commands())
      if (command.topic == topic.name)
        names += (names.empty() ? "" : " ") + std::string{command.name};
    printWrapped(console, begin, std::string{topic.help} + ": " + names, widest + 2);
  }
  console.print("help TOPIC and help COMMAND print more, help all prints everything.");
}

std::vector<std::string> helpNames(Console&, const Words&) {
  std::vector<std::string> names{"all"};
  for (const HelpTopic& topic : topics()) names.emplace_back(topic.name);
  for (const Command& command : Console::commands()) names.emplace_back(command.name);
  return names;
}

Result<void> help(Console& console, const Words& words) {
  if (words.size() == 1) {
    printTopics(console);
    return {};
  }
  bool found = false;
  for (const Command& command : Console::commands())
    if (words[1] == "all" || words[1] == command.name ||
        (words[1] == command.topic && !Console::find(words[1]))) {
      printHelp(console, command);
      found = true;
    }
  if (found) return {};
  return Error{.field = words[1],
               .what = "there is no such command or topic" +
                       suggestion(words[1], helpNames(console, words))};
}

Result<void> echo(Console& console, const Words& words) {
  console.print(words.rest);
  const auto echoed = splitWords(words.rest);
  if (echoed && !echoed->empty() && Console::find(echoed->front())) console.offer(words.rest);
  return {};
}

Result<void> comment(Console&, const Words&) {
  return {};
}

Result<void> cls(Console& console, const Words&) {
  console.session().screen().clear();
  return {};
}

Result<void> call(Console& console, const Words& words) {
  return console.call(words[1]);
}

Result<void> end(Console& console, const Words&) {
  console.end();
  return {};
}

}  // namespace

std::vector<Command> scriptCommands() {
  using enum Command::Kind;
  return {
      {global, "#", "TEXT", "A comment.", comment},
      {global, "?", "[TOPIC | NAME | ? | all]", "The same as help.", help, helpNames},
      {global, "call", "SCRIPT",
       "Executes a script, one command per line; from scenes/ and with .con if the file has no "
       "folder and extension.",
       call},
      {global, "cls", "", "Clears the console.", cls},
      {global, "echo", "[TEXT]",
       "Prints a text. If that is a command, the user finds it in the history.", echo},
      {global, "exit", "", "Ends the scripts that run, and the program.", end},
      {global, "help", "[TOPIC | NAME | ? | all]",
       "Lists the topics with their commands, or explains one of them, or all.", help, helpNames},
      {global, "quit", "", "The same as exit.", end}};
}

}  // namespace gt
