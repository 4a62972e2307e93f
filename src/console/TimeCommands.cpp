#include <algorithm>
#include <cmath>
#include <filesystem>

#include "console/Commands.h"
#include "console/Condition.h"
#include "modules/behavior/control/BehaviorRequest.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

/// Longest that until waits without a word, in simulated seconds.
constexpr double untilAtMost = 600;
constexpr double longest = 1e6;  // s

/// A duration from a word on: 30, 30 s, 500 ms, 2 min or 10 steps; in ms.
Result<std::int64_t> durationOf(const Words& words, std::size_t first) {
  if (words.size() != first + 1 && words.size() != first + 2) return wrongArguments(words);
  const auto number = numberOf(words[first], 0, longest);
  if (!number) return number.error();
  const std::string unit = words.size() == first + 2 ? words[first + 1] : "s";
  const double ms = unit == "s"                         ? 1000
                    : unit == "ms"                      ? 1
                    : unit == "min"                     ? 60000
                    : unit == "steps" || unit == "step" ? static_cast<double>(tickMs)
                                                        : 0;
  if (ms == 0) return Error{"", 0, unit, "is no unit of time: expected s, ms, min or steps"};
  return std::llround(*number * ms);
}

Result<void> run(Console& console, const Words& words) {
  const auto ms = durationOf(words, 1);
  if (!ms) return ms.error();
  const Time end = console.session().time() + *ms;
  while (console.session().time() < end && console.session().step()) {
  }
  return {};
}

/// The condition that a line holds, and the seconds behind its last `within`, if any.
struct Waiting {
  Condition condition;
  double seconds = untilAtMost;
};

Result<Waiting> waitingOf(const Words& words) {
  std::string text = words.rest;
  Waiting waiting;
  if (words.size() > 3 && words[words.size() - 2] == "within") {
    const auto seconds = numberOf(words.back(), 0, longest);
    if (!seconds) return seconds.error();
    waiting.seconds = *seconds;
    text = text.substr(0, text.rfind("within"));
  }
  auto condition = Condition::parse(text);
  if (!condition) return condition.error();
  waiting.condition = std::move(*condition);
  return waiting;
}

Result<void> until(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  const auto waiting = waitingOf(words);
  if (!waiting) return waiting.error();
  const Time end = console.session().time() + std::llround(1000 * waiting->seconds);
  while (true) {
    const auto holds = waiting->condition.holds(console);
    if (!holds) return holds.error();
    if (*holds) return {};
    if (console.session().time() >= end || !console.session().step()) break;
  }
  console.failExpectation();
  return Error{"", 0, "until", "did not come true: " + words.rest};
}

Result<void> expect(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  const auto condition = Condition::parse(words.rest);
  if (!condition) return condition.error();
  const auto holds = condition->holds(console);
  if (!holds) return holds.error();
  if (*holds) return {};
  console.failExpectation();
  return Error{"", 0, "expect", "does not hold: " + words.rest};
}

/// Values, parameters and objects of the scene whose names begin so.
void listValues(Console& console, const std::string& begin) {
  const auto tell = [&](const std::string& name, const std::string& more, std::string_view doc) {
    if (name.starts_with(begin))
      console.print(name + more + (doc.empty() ? "" : "  // " + std::string{doc}));
  };
  for (const std::string& name : valueNames(console)) tell(name, "", "");
  if (const auto robot = console.firstRobot())
    for (const ProcessDescription& process : describe(**robot))
      for (const TaskDescription& task : process.tasks)
        for (const SolutionDescription& solution : task.solutions)
          for (const ParameterDescription& p : solution.parameters)
            tell(task.name + "." + solution.name + "." + p.path,
                 " " + p.value + (p.unit.empty() ? "" : " " + p.unit), p.doc);
  SceneTree& tree = console.session().tree();
  for (const SceneTree::Object& object : tree.list(""))
    if (const auto value = tree.get(object.path))
      tell(object.path, " " + *value + (object.canBeSet ? "" : " (only watched)"), object.help);
}

Result<void> get(Console& console, const Words& words) {
  if (words.size() > 1 && words[1] == "?" && words.size() <= 3) {
    listValues(console, words.size() == 3 ? words[2] : "");
    return {};
  }
  if (words.size() != 2) return wrongArguments(words);
  // What a robot has is told of each selected one; what there is once, once.
  const std::string first = words[1].substr(0, words[1].find('.'));
  const auto robots = console.selected();
  const bool ofRobots = !robots.empty() && !console.session().find(first) &&
                        (solutions().find(first) ||
                         (robots.front()->robot() && robots.front()->robot()->value(first)));
  if (ofRobots)
    return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
      const auto value = valueAt(console, robot.name() + "." + words[1]);
      if (!value) return value.error();
      console.print(robot.name() + ": " + value->text);
      return {};
    });
  const auto value = valueAt(console, words[1]);
  if (!value) return value.error();
  console.print(value->text);
  return {};
}

Result<void> set(Console& console, const Words& words) {
  if (words.size() < 3) return wrongArguments(words);
  std::string value = words[2];
  for (std::size_t i = 3; i < words.size(); ++i) value += " " + words[i];
  if (const auto object = objectPath(console.session(), words[1]))
    return console.session().tree().set(*object, value);
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    const auto name = parameterName(robot, words[1]);
    if (!name) return name.error();
    return robot.request(ParameterRequest{name->task, name->solution, name->path, value});
  });
}

std::vector<std::string> parameterChoices(Console& console, const Words& before) {
  std::vector<std::string> names;
  if (before.size() > 1) return names;
  for (const SceneTree::Object& object : console.session().tree().list(""))
    if (object.canBeSet || before.front() == "get") names.push_back(object.path);
  const auto robot = console.firstRobot();
  if (!robot) return names;
  for (const ProcessDescription& process : describe(**robot))
    for (const TaskDescription& task : process.tasks)
      for (const SolutionDescription& solution : task.solutions)
        for (const ParameterDescription& p : solution.parameters)
          names.push_back(task.name + "." + solution.name + "." + p.path);
  return names;
}

std::vector<std::string> valueChoices(Console& console, const Words& before) {
  if (before.front() == "get" && before.size() > 1) return {};
  auto names = valueNames(console);
  for (std::string& name : parameterChoices(console, {"get"})) names.push_back(std::move(name));
  return names;
}

Result<void> behavior(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  return console.forEachRobot([&](ConsoleRobot& robot) {
    return robot.request(BehaviorRequest{words[1], {}});
  });
}

Result<void> restart(Console& console, const MatchOptions& options) {
  if (auto done = console.session().restart(options); !done) return done;
  console.select({});
  console.forgetBehavior();
  console.series().clear();
  return {};
}

Result<void> seed(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const auto number = numberOf(words[1], 0, 9e15);
  if (!number) return number.error();
  MatchOptions options = console.session().options();
  options.seed = static_cast<std::uint64_t>(*number);
  return restart(console, options);
}

Result<void> scene(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  MatchOptions options = console.session().options();
  options.scene = withDefaults(words[1], "scenes", ".scene");
  return restart(console, options);
}

Result<void> reset(Console& console, const Words& words) {
  if (words.size() != 1) return wrongArguments(words);
  return restart(console, console.session().options());
}

Result<void> save(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const std::string file = withDefaults(words[1], "out/states", ".state");
  std::error_code ignored;  // then writing tells what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  return console.session().match().save(file);
}

Result<void> load(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const auto selection = console.selection();
  console.select({});
  console.forgetBehavior();
  const auto done = console.session().load(
      withDefaults(words[1], "out/states", ".state"), [&](const std::string& line) -> Result<void> {
        const Command* command = Console::find(line.substr(0, line.find(' ')));
        if (!command || !command->changes)
          return Error{"", 0, line, "is no command that changes something"};
        return console.execute(line);
      });
  if (!done) {
    console.select(selection);
    console.forgetBehavior();
    return done;
  }
  console.series().clear();
  return {};
}

Result<void> joystick(Console& console, const Words& words) {
  if (words.size() != 3) return wrongArguments(words);
  Joystick& stick = console.joystick();
  if (const auto axis = enumValue<Joystick::Axis>(words[1])) {
    const auto value = numberOf(words[2], -1, 1);
    if (!value) return value.error();
    stick.move(*axis, *value);
    return moveByJoystick(console);
  }
  const bool down = words[1] == "press";
  if (!down && words[1] != "release") return wrongArguments(words);
  const auto button = numberOf(words[2], 1, Joystick::buttons);
  if (!button) return button.error();
  const auto command = stick.press(static_cast<int>(*button), down);
  return command ? console.executeWithin(*command) : Result<void>{};
}

std::vector<std::string> sceneChoices(Console&, const Words&) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator{"scenes", failed})
    if (entry.path().extension() == ".scene") names.push_back(entry.path().stem().string());
  return names;
}

}  // namespace

std::vector<Command> simulationCommands() {
  using enum Command::Kind;
  return {
      {robot, "behavior", "FILE",
       "Goes on with a behavior, or with the same one after it was edited.", behavior, nullptr,
       true},
      {global, "expect", "CONDITION",
       "Tells whether a condition holds; a script ends here if not, with exit status 1.", expect,
       valueChoices},
      {robot, "get", "? [BEGIN] | VALUE",
       "Prints a value by its path: of the game, a ball, a robot's body, its representations, its "
       "parameters, or any object of the scene. With ? all of them, or those that begin so.",
       get, valueChoices},
      {global, "joystick", "(press | release) BUTTON | AXIS VALUE",
       "Does what a joystick does: its buttons 1 to 32, and its axes x, y, z, accelerator, hatX "
       "and "
       "hatY from -1 to 1, which move the selected robots.",
       joystick, nullptr, true},
      {global, "load", "FILE", "Goes on where a simulation was when it was saved.", load},
      {global, "reset", "", "Begins anew, with the same scene and seed.", reset},
      {global, "run", "NUMBER [s | ms | min | steps]", "Lets simulated time pass.", run},
      {global, "save", "FILE",
       "Saves the state of the simulation: scene, seed and all that was done since, which is lived "
       "through again when it is loaded. To out/states/ and with .state if the file has no folder "
       "and extension.",
       save},
      {global, "scene", "FILE", "Begins with another scene.", scene, sceneChoices},
      {global, "seed", "NUMBER", "Begins anew with another seed.", seed},
      {robot, "set", "TASK[.SOLUTION].PATH VALUE | OBJECT VALUE",
       "Sets a parameter; or moves or switches an object of the scene, such as "
       "robots/red1/joints/headPan.",
       set, parameterChoices, true},
      {global, "until", "CONDITION [within SECONDS]",
       "Lets simulated time pass until a condition holds; fails like expect if that takes longer "
       "(600 s without a word).",
       until, valueChoices}};
}

}  // namespace gt
