#pragma once
#include "console/Console.h"

namespace gt {

// The parts of the table of commands; each is a file and a topic of the help.
std::vector<Command> scriptCommands();
std::vector<Command> connectionCommands();
std::vector<Command> timeCommands();
std::vector<Command> gameCommands();
std::vector<Command> worldCommands();
std::vector<Command> valueCommands();
std::vector<Command> robotCommands();
std::vector<Command> configurationCommands();  ///< Commands about configurations of robots.
std::vector<Command> logCommands();            ///< Commands about logs of robots.
std::vector<Command> motionCommands();
std::vector<Command> mofCommands();
std::vector<Command> joystickCommands();
std::vector<Command> soundCommands();
std::vector<Command> behaviorCommands();
std::vector<Command> viewCommands();
std::vector<Command> testCommands();

/// Parses a number; an error that names the word if it is none.
Result<double> numberOf(const std::string& word);
/// Parses a number; an error if it is out of the limits.
Result<double> numberOf(const std::string& word, double low, double high);
/// The error of a command whose arguments do not match its usage, which it states.
Error wrongArguments(const Words& words);
/// Adds a folder and an extension to a file's name where it has none.
std::string withDefaults(const std::string& file, const std::string& folder,
                         const std::string& extension);
/// As `withDefaults`, with a folder of the data root.
std::string dataFile(Console& console, const std::string& file, const std::string& folder,
                     const std::string& extension);
/// The names of an enumeration's values.
template <typename E>
std::vector<std::string> namesOf() {
  return {enumNames<E>.begin(), enumNames<E>.end()};
}
/// Prints the lines.
void list(Console& console, const std::vector<std::string>& lines);
/// The descriptions that all processes of a robot report; of a remote robot, those that have
/// arrived.
std::vector<ProcessDescription> describe(ConsoleRobot& robot);
/// The names of values for `get`, `plot` and conditions.
std::vector<std::string> valueChoices(Console& console, const Words& before);
/// The debug keys of a drawing, given by the key itself or by a name of the report, such as
/// imageProcessor_horizon. Empty if there is no such drawing.
std::vector<std::string> drawingKeys(const std::string& name);
/// Prints the differences if a command has just put something not as it was requested.
void printPut(Console& console);
/// Prints the name of a file that was written.
void printWritten(Console& console, const std::string& file);
/// Finds a name in a list, also if it is spelled as in the report: ball.time-since-last-seen is
/// ball.time_since_last_seen. Null if there is none.
const std::string* findName(const std::vector<std::string>& names, std::string_view word);

}  // namespace gt
