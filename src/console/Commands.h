#pragma once
#include "console/Console.h"

namespace gt {

// The parts of the table, a file each.
std::vector<Command> globalCommands();      ///< Report I.5.1, I.5.2.
std::vector<Command> robotCommands();       ///< Report I.5.3.
std::vector<Command> motionCommands();      ///< Of these, those that move the robots.
std::vector<Command> behaviorCommands();    ///< Of these, those about Xabsl2.
std::vector<Command> simulationCommands();  ///< Time, values, conditions, states.
std::vector<Command> worldCommands();       ///< Robots and balls moved by hand.
std::vector<Command> testCommands();        ///< Many games or situations.
std::vector<Command> viewCommands();        ///< Pictures, plots, films.

/// A number; an error that names the word if it is none.
Result<double> numberOf(const std::string& word);
/// A number within limits.
Result<double> numberOf(const std::string& word, double low, double high);
/// True for on, false for off; an error otherwise.
Result<bool> switchOf(const Words& words, std::size_t word);
/// The error of a command whose arguments are wrong: tells how they should be.
Error wrongArguments(const Words& words);
/// A file's name with a folder and an extension if it has none.
std::string withDefaults(const std::string& file, const std::string& folder,
                         const std::string& extension);
/// The names of an enumeration's values.
template <typename E>
std::vector<std::string> namesOf() {
  return {enumNames<E>.begin(), enumNames<E>.end()};
}
/// Choices for a command's first argument.
template <const char*... words>
std::vector<std::string> oneOf(Console&, const Words& before) {
  return before.size() == 1 ? std::vector<std::string>{words...} : std::vector<std::string>{};
}
/// Prints a line each.
void list(Console& console, const std::vector<std::string>& lines);
/// What all processes of a robot say of themselves; of a robot elsewhere, what this program knows.
std::vector<ProcessDescription> describe(ConsoleRobot& robot);
/// Has the selected robots do what the joystick's axes say now.
Result<void> moveByJoystick(Console& console);
/// A name of a list as it may be written in the report: ball.time-since-last-seen is
/// ball.time_since_last_seen. Null if there is none.
const std::string* findName(const std::vector<std::string>& names, std::string_view word);

}  // namespace gt
