#include <algorithm>

#include "base/Suggestion.h"
#include "console/Commands.h"
#include "console/Condition.h"
#include "console/Values.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

Result<void> expect(Console& console, const Words& words) {
  const auto condition = Condition::parse(words.rest);
  if (!condition) return condition.error();
  const auto holds = condition->holds(console);
  if (!holds) return holds.error();
  if (*holds) return {};
  console.failExpectation();
  return Error{.field = "expect", .what = "does not hold: " + words.rest};
}

/// The notation of an object of the scene in values and conditions.
std::string dotted(std::string path) {
  std::ranges::replace(path, '/', '.');
  return path;
}

/// Prints the values, parameters and objects of the scene whose names begin with `begin`.
void listValues(Console& console, const std::string& begin) {
  const auto list = [&](const std::string& name, const std::string& more, std::string_view doc) {
    if (name.starts_with(begin))
      console.print(name + more + (doc.empty() ? "" : "  // " + std::string{doc}));
  };
  for (const std::string& name : valueNames(console)) list(name, "", "");
  if (const auto robot = console.firstRobot())
    for (const ProcessDescription& process : describe(**robot))
      for (const TaskDescription& task : process.tasks)
        for (const SolutionDescription& solution : task.solutions)
          for (const ParameterDescription& p : solution.parameters)
            list(task.name + "." + solution.name + "." + p.path,
                 " " + p.value + (p.unit.empty() ? "" : " " + p.unit), p.doc);
  SceneTree& tree = console.session().tree();
  for (const SceneTree::Object& object : tree.list(""))
    if (const auto value = tree.get(object.path))
      list(dotted(object.path), " " + *value + (object.canBeSet ? "" : " (only watched)"),
           object.help);
}

/// Prints a value, or all values that lie below a path; false if there is none.
bool printValues(Console& console, const std::string& robot, const std::string& path) {
  const std::string begin = robot.empty() ? "" : robot + ": ";
  const std::string prefix = robot.empty() ? "" : robot + ".";
  if (const auto value = valueAt(console, prefix + path)) {
    console.print(begin + value->text);
    return true;
  }
  bool any = false;
  for (const std::string& name : valueChoices(console, {"get"})) {
    if (!name.starts_with(path + ".")) continue;
    const auto value = valueAt(console, prefix + name);
    if (!value) continue;
    console.print(begin + name + " " + value->text);
    any = true;
  }
  return any;
}

Error noValue(Console& console, const std::string& path) {
  const auto value = valueAt(console, path);
  if (value) return {};
  if (isOfMissingBody(console.session(), path)) return value.error();
  const std::string found = suggestion(path, valueChoices(console, {"get"}));
  return {.field = path, .what = value.error().what + found};
}

Result<void> get(Console& console, const Words& words) {
  if (words[1] == "?") {
    listValues(console, words.size() == 3 ? dotted(words[2]) : "");
    return {};
  }
  // What a robot has is printed for each selected one; what there is once, once.
  const std::string& path = words[1];
  const std::string first = path.substr(0, path.find('.'));
  const auto robots = console.selected();
  const bool ofRobots =
      !robots.empty() && !console.session().find(first) && robots.front()->observed().has(first);
  if (ofRobots)
    return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
      if (printValues(console, robot.name(), path)) return {};
      return noValue(console, robot.name() + "." + path);
    });
  if (printValues(console, "", path)) return {};
  // A group of values of a robot that is named.
  if (console.session().find(first) && path.size() > first.size() &&
      printValues(console, first, path.substr(first.size() + 1)))
    return {};
  return noValue(console, path);
}

Result<void> set(Console& console, const Words& words) {
  std::string value = words[2];
  for (std::size_t i = 3; i < words.size(); ++i) value += " " + words[i];
  if (const auto object = objectPath(console.session(), words[1])) {
    const auto puts = [&] { return console.session().simulation().world().putCount(); };
    const std::size_t before = puts();
    auto done = console.session().tree().set(*object, value);
    if (puts() != before) printPut(console);
    return done;
  }
  const std::size_t dot = words[1].find('.');
  if (ConsoleRobot* const named = console.session().find(words[1].substr(0, dot)))
    if (dot != std::string::npos) return named->observed().set(words[1].substr(dot + 1), value);
  return console.forEachRobot(
      [&](ConsoleRobot& robot) -> Result<void> { return robot.observed().set(words[1], value); });
}

/// Parameters, and objects of the scene.
std::vector<std::string> parameterNames(Console& console, bool alsoWatched) {
  std::vector<std::string> names;
  for (const SceneTree::Object& object : console.session().tree().list(""))
    if (object.canBeSet || alsoWatched) names.push_back(dotted(object.path));
  const auto robot = console.firstRobot();
  if (!robot) return names;
  for (const ProcessDescription& process : describe(**robot))
    for (const TaskDescription& task : process.tasks)
      for (const SolutionDescription& solution : task.solutions)
        for (const ParameterDescription& p : solution.parameters)
          names.push_back(task.name + "." + solution.name + "." + p.path);
  return names;
}

std::vector<std::string> settableNames(Console& console, const Words& before) {
  return before.size() == 1 ? parameterNames(console, false) : std::vector<std::string>{};
}

}  // namespace

std::vector<std::string> valueChoices(Console& console, const Words&) {
  auto names = valueNames(console);
  for (std::string& name : parameterNames(console, true)) names.push_back(std::move(name));
  return names;
}

std::vector<Command> valueCommands() {
  using enum Command::Kind;
  return {
      {global, "expect", "CONDITION",
       "Checks whether a condition holds; a script ends here if not, with exit status 1.", expect,
       valueChoices},
      {robot, "get", "? [BEGIN] | VALUE",
       "Prints a value by its path: of the game, a ball, a robot's body, its representations, its "
       "parameters, or any object of the scene; or all values below a path: get RobotPose. With ? "
       "it lists all, or those that begin so.",
       get, valueChoices},
      {robot, "set", "[ROBOT.]TASK[.SOLUTION].PATH VALUE {VALUE} | OBJECT VALUE {VALUE}",
       "Sets a parameter or a field of a representation, of the selected robots or of the one that "
       "is named; or moves or switches an object of the scene, such as "
       "robots.red1.joints.headPan.",
       set, settableNames, true}};
}

}  // namespace gt
