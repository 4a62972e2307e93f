#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "robot/Robot.h"

namespace gt {

/// The robots and the clock that a console works on. Provided by the program that plays.
class ConsoleWorld {
 public:
  /// A robot by the name that the console calls it.
  struct NamedRobot {
    std::string name;
    Robot* robot;
  };

  virtual ~ConsoleWorld() = default;
  virtual std::vector<NamedRobot> robots() = 0;
  /// One step of the simulation; false when all is over.
  virtual bool step() = 0;
  virtual Time time() const = 0;
  virtual void print(std::string_view line) = 0;
};

/// The words of a command line. What begins with a quote goes on to the next one.
using Words = std::vector<std::string>;

class Console;

/// A command of the console: help and completion come from this table, too.
struct Command {
  enum class Kind { global, robot };

  Kind kind;
  std::string_view name;
  std::string_view arguments;  ///< As in the report's I.5.
  std::string_view help;
  Result<void> (*execute)(Console& console, const Words& words);
};

/// Executes commands and scripts (report I.5, I.6). Global commands change the whole; robot
/// commands work on the selected robots, at the start all of them.
class Console {
 public:
  explicit Console(ConsoleWorld& world) : world_{world} {}

  /// Executes one line. Errors name the line's command or the word that is wrong.
  Result<void> execute(std::string_view line);
  /// Executes a script, one command per line, up to the first error: it names file and line.
  Result<void> call(const std::string& path);

  /// Commands by name; null if there is none.
  static const std::vector<Command>& commands();
  static const Command* find(std::string_view name);

  ConsoleWorld& world() { return world_; }
  /// The robots that robot commands are for.
  std::vector<ConsoleWorld::NamedRobot> selected();
  void select(std::vector<std::string> names) { selected_ = std::move(names); }
  /// Does something for each selected robot, up to the first error, which tells the robot's name.
  Result<void> forEachRobot(const std::function<Result<void>(Robot&)>& work);

 private:
  ConsoleWorld& world_;
  std::vector<std::string> selected_;  ///< All if empty.
  int depth_ = 0;                      ///< Scripts that call each other.
};

/// Splits a line into words; an error if a quote is not closed.
Result<Words> splitWords(std::string_view line);

}  // namespace gt
