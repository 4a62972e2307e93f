#pragma once
#include "console/Console.h"

namespace gt {

// The parts of the table: a file and a topic of the help each.
std::vector<Command> scriptCommands();
std::vector<Command> connectionCommands();
std::vector<Command> timeCommands();
std::vector<Command> gameCommands();
std::vector<Command> worldCommands();
std::vector<Command> valueCommands();
std::vector<Command> robotCommands();
std::vector<Command> configurationCommands();  ///< Of these, that about configurations.
std::vector<Command> logCommands();            ///< Of these, those about logs.
std::vector<Command> motionCommands();
std::vector<Command> mofCommands();
std::vector<Command> joystickCommands();
std::vector<Command> soundCommands();
std::vector<Command> behaviorCommands();
std::vector<Command> viewCommands();
std::vector<Command> testCommands();

/// A number; an error that names the word if it is none.
Result<double> numberOf(const std::string& word);
/// A number within limits.
Result<double> numberOf(const std::string& word, double low, double high);
/// The error of a command whose arguments do not match its usage: reports how they should be.
Error wrongArguments(const Words& words);
/// A file's name with a folder and an extension if it has none.
std::string withDefaults(const std::string& file, const std::string& folder,
                         const std::string& extension);
/// The same, with a folder of the data root.
std::string dataFile(Console& console, const std::string& file, const std::string& folder,
                     const std::string& extension);
/// The names of an enumeration's values.
template <typename E>
std::vector<std::string> namesOf() {
  return {enumNames<E>.begin(), enumNames<E>.end()};
}
/// Prints a line each.
void list(Console& console, const std::vector<std::string>& lines);
/// What all processes of a robot report about themselves; of a robot elsewhere, what has arrived
/// of that.
std::vector<ProcessDescription> describe(ConsoleRobot& robot);
/// What `get`, `plot` and conditions may name.
std::vector<std::string> valueChoices(Console& console, const Words& before);
/// The keys of a debug drawing: its own, or those behind a name of the report, such as
/// imageProcessor_horizon. Empty if there is no such drawing.
std::vector<std::string> drawingKeys(const std::string& name);
/// Prints what a command has just put by hand, if it is not put as it was asked.
void printPut(Console& console);
/// Prints where something was written.
void printWritten(Console& console, const std::string& file);
/// A name of a list as it may be written in the report: ball.time-since-last-seen is
/// ball.time_since_last_seen. Null if there is none.
const std::string* findName(const std::vector<std::string>& names, std::string_view word);

}  // namespace gt
