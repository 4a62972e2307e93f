#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/File.h"
#include "base/Suggestion.h"
#include "console/Commands.h"
#include "match/SimulatedRobot.h"
#include "robot/Solutions.h"
#include "streams/Config.h"
#include "views/graphs/Graphviz.h"
#include "views/graphs/ModuleGraph.h"

namespace gt {
namespace {

/// Solutions of the report (chapter 3's table) by the report's names of their tasks. Its scripts
/// may name them even if this system lacks them.
constexpr std::pair<std::string_view, std::string_view> reportSolutions[] = {
    {"ImageProcessor", "GridImageProcessor2"},
    {"ImageProcessor", "GridImageProcessor3"},
    {"ImageProcessor", "GridImageProcessorTSL"},
    {"ImageProcessor", "CheckerboardDetector"},
    {"BallLocator", "BallChallenge"},
    {"ObstaclesLocator", "Default"},
    {"CollisionDetector", "Default"},
    {"PlayersLocator", "GO2003"},
    {"SelfLocator", "Fusion"},
    {"SelfLocator", "Fusion2003"},
    {"SelfLocator", "GT2003"},
    {"SelfLocator", "Lines"},
    {"SelfLocator", "SingleLandmark"},
    {"MotionControl", "Debug"},
    {"SoundControl", "Default"},
    {"SensorBehaviorControl", "ObstacleAvoiderOnGreenField"}};

bool inReport(std::string_view task, std::string_view solution) {
  return std::ranges::any_of(reportSolutions, [&](const auto& known) {
    return known.first == task && (known.second == solution || solution == SolutionTable::disabled);
  });
}

/// The meaning of the report's debug keys (I.3.3, I.6): debug keys of this system, or
/// representations that are sent. Besides, "send" and the name of a representation requests it.
struct ReportKey {
  std::string_view name;
  std::vector<std::string> keys;
  std::vector<std::string> representations;
};

const std::vector<ReportKey>& reportKeys() {
  static const std::vector<ReportKey> list{
      {"sendImage", {}, {"Image", "CameraMatrix"}},
      {"sendJPEGImage", {}, {"Image", "CameraMatrix"}},
      {"sendPercepts",
       {"ImageProcessor/percepts"},
       {"BallPercept", "LandmarksPercept", "LinesPercept", "PlayersPercept", "ObstaclesPercept"}},
      {"sendWorldState", {"BallLocator/ball", "SelfLocator/pose"}, {"RobotPose", "BallModel"}},
      {"sendXabsl2DebugMessages", {"BehaviorControl/activations"}, {}},
      {"send_imageProcessor_horizon_drawing", {"ImageProcessor/horizon"}, {}},
      {"send_imageProcessor_scanLines_drawing", {"ImageProcessor/grid"}, {}},
      {"send_perceptCollection_drawing", {"ImageProcessor/percepts"}, {}},
      {"send_selfLocator_drawing", {"SelfLocator/pose"}, {}},
      {"send_selfLocatorField_drawing", {"SelfLocator/samples", "SelfLocator/pose"}, {}},
      {"send_worldState_drawing",
       {"BallLocator/ball", "TeamBallLocator/ball", "PlayersLocator/players"},
       {}}};
  return list;
}

/// The tasks of the first selected robot, as it describes them: it may be another program.
std::vector<TaskDescription> tasksOfFirst(Console& console) {
  std::vector<TaskDescription> tasks;
  const auto robot = console.firstRobot();
  if (!robot) return tasks;
  for (ProcessDescription& process : describe(**robot))
    std::ranges::move(process.tasks, std::back_inserter(tasks));
  std::ranges::sort(tasks, {}, &TaskDescription::name);
  return tasks;
}

std::vector<std::string> debugKeyNames(Console& console, const Words& before) {
  if (before.size() == 3) return {"off", "on", "every"};
  std::vector<std::string> names;
  if (before.size() != 1 && before.size() != 2) return names;
  if (before.size() == 2) return {"off", "on", "every"};
  if (const auto robot = console.firstRobot()) names = (*robot)->observed().debugKeys();
  for (const ReportKey& key : reportKeys()) names.emplace_back(key.name);
  for (const TaskDescription& task : tasksOfFirst(console))
    for (const std::string& output : task.outputs) names.push_back("send" + output);
  names.emplace_back("?");
  return names;
}

Result<DebugKeyRequest> debugKeyRequest(const Words& words) {
  if (words[2] == "off") return DebugKeyRequest{};
  if (words[2] == "on") return DebugKeyRequest{DebugKeyMode::always, 0};
  const bool every = words.size() > 3 && words[2] == "every";
  const bool ms = words.size() == 5;
  const auto n = numberOf(words[every ? 3 : 2]);
  if (!n) return n.error();
  if (*n < 1 || *n > 1e9 || *n != std::floor(*n)) return wrongArguments(words);
  const DebugKeyMode mode = ms      ? DebugKeyMode::everyMs
                            : every ? DebugKeyMode::everyTimes
                                    : DebugKeyMode::times;
  return DebugKeyRequest{mode, static_cast<std::int64_t>(*n)};
}

Result<void> setKey(ObservedRobot& robot, const std::string& name, const DebugKeyRequest& often) {
  const auto known =
      std::ranges::find_if(reportKeys(), [&](const ReportKey& key) { return key.name == name; });
  if (known != reportKeys().end()) {
    for (const std::string& key : known->keys)
      if (auto done = robot.request(DebugRequest{key, often.mode, often.n}); !done) return done;
    // A robot on a log has only some of the representations.
    for (const std::string& representation : known->representations)
      if (const auto done = robot.watch(representation, often);
          !done && known->representations.size() == 1)
        return done;
    return {};
  }
  const bool isKey = std::ranges::binary_search(robot.debugKeys(), name);
  if (!isKey && name.starts_with("send") && name.size() > 4)
    return robot.watch(name.substr(4), often);
  return robot.request(DebugRequest{name, often.mode, often.n});
}

Result<void> dk(Console& console, const Words& words) {
  if (words[1] == "?") {
    auto names = debugKeyNames(console, {"dk"});
    std::erase(names, "?");
    std::sort(names.begin(), names.end());
    list(console, names);
    return {};
  }
  const auto often = debugKeyRequest(words);
  if (!often) return often.error();
  return console.forEachRobot(
      [&](ConsoleRobot& robot) { return setKey(robot.observed(), words[1], *often); });
}

std::vector<std::string> taskNames(Console& console, const Words& before) {
  std::vector<std::string> names;
  for (const TaskDescription& task : tasksOfFirst(console)) {
    if (before.size() == 1) names.push_back(task.name);
    if (before.size() != 2 || task.name != before[1]) continue;
    for (const SolutionDescription& solution : task.solutions) names.push_back(solution.name);
    names.emplace_back(SolutionTable::disabled);
  }
  names.emplace_back("?");
  return names;
}

/// The report's scripts name the solution GT2003-soccer that is GT2003 here.
std::string solutionName(const std::vector<std::string>& known, const std::string& word) {
  if (std::ranges::find(known, word) == known.end())
    for (const std::string& solution : known)
      if (word.starts_with(solution + "-")) return solution;
  return word;
}

Result<void> switchSolution(Console& console, ConsoleRobot& robot, const std::string& task,
                            const std::string& word) {
  std::optional<std::vector<std::string>> known;  // of the robot, which may be another program
  for (const ProcessDescription& process : describe(robot))
    for (const TaskDescription& described : process.tasks)
      if (described.name == task) known = namesIn(described.solutions);
  const Task* const here = solutions().find(task);
  const auto ours = here ? namesIn(here->solutions) : std::vector<std::string>{};
  const bool off = word == SolutionTable::disabled;
  const std::string solution = solutionName(known.value_or(ours), word);
  const auto isIn = [&](const std::vector<std::string>& names) {
    return off || std::ranges::find(names, solution) != names.end();
  };
  if (known && isIn(*known)) return robot.observed().request(SolutionRequest{task, solution});
  if (!known && here && isIn(ours)) {
    // What no process of this robot does is disabled already; on a log, the log does it.
    if (!off) console.print(robot.name() + ": no process of this robot solves " + task);
    return {};
  }
  if (inReport(task, solution)) {
    if (!off)
      console.print(robot.name() + ": this system has no solution " + solution + " of " + task +
                    "; the present one keeps running");
    return {};
  }
  if (!known && !here) return Error{.field = task, .what = "no process solves this task"};
  return Error{.field = task,
               .what = "there is no solution '" + solution + "'; try sr " + task + " ?" +
                       suggestion(solution, known.value_or(ours))};
}

std::vector<std::string> tasksOf(ConsoleRobot& robot) {
  std::vector<std::string> lines;
  for (const ProcessDescription& process : describe(robot))
    for (const TaskDescription& task : process.tasks)
      lines.push_back(task.name + (task.active.empty() ? "" : " " + task.active));
  return lines;
}

Result<std::vector<std::string>> solutionsOf(ConsoleRobot& robot, const std::string& name) {
  for (const ProcessDescription& process : describe(robot))
    for (const TaskDescription& task : process.tasks) {
      if (task.name != name) continue;
      std::vector<std::string> lines;
      for (const SolutionDescription& solution : task.solutions) lines.push_back(solution.name);
      lines.emplace_back(SolutionTable::disabled);
      for (std::string& line : lines)
        if (line == task.active) line += " (runs)";
      return lines;
    }
  return Error{.field = name, .what = "no process solves this task; try sr ?"};
}

Result<void> sr(Console& console, const Words& words) {
  if (words.back() == "?") {
    const auto robot = console.firstRobot();
    if (!robot) return robot.error();
    if (words.size() == 2) {
      list(console, tasksOf(**robot));
      return {};
    }
    const auto lines = solutionsOf(**robot, words[1]);
    if (!lines) return lines.error();
    list(console, *lines);
    return {};
  }
  return console.forEachRobot(
      [&](ConsoleRobot& robot) { return switchSolution(console, robot, words[1], words[2]); });
}

/// The possible receivers of generic debug data: each task, and each of its solutions.
std::vector<std::string> idNames(Console& console, const Words& before) {
  if (before.size() > 1) return {};
  std::vector<std::string> names{"?"};
  for (const TaskDescription& task : tasksOfFirst(console)) {
    names.push_back(task.name);
    for (const SolutionDescription& solution : task.solutions)
      names.push_back(task.name + "." + solution.name);
  }
  return names;
}

/// The report's ids name a solution and its task: defaultObstaclesLocator.
std::string idOf(Console& console, std::string word) {
  for (const TaskDescription& task : tasksOfFirst(console))
    for (const SolutionDescription& solution : task.solutions) {
      std::string id = solution.name + task.name;
      id.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(id.front())));
      if (id == word) return task.name + "." + solution.name;
    }
  return word;
}

Result<void> sg(Console& console, const Words& words) {
  if (words[1] == "?") {
    auto names = idNames(console, {"sg"});
    std::erase(names, "?");
    list(console, names);
    return {};
  }
  constexpr std::size_t mostNumbers = 10;  // report I.5.3
  if (words.size() > 2 + mostNumbers) return wrongArguments(words);
  GenericDebugData data{idOf(console, words[1]), {}};
  if (const auto names = idNames(console, {"sg"}); std::ranges::find(names, data.id) == names.end())
    return Error{.field = words[1], .what = "there is no such id; try sg ?"};
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto number = numberOf(words[i]);
    if (!number) return number.error();
    data.data.push_back(*number);
  }
  return console.forEachRobot([&](ConsoleRobot& robot) { return robot.observed().request(data); });
}

Result<void> qfr(Console& console, const Words& words) {
  QueueFillRequest request{*enumValue<QueueFillMode>(words[1]), 0};
  if (words.size() == 3) {
    const auto seconds = numberOf(words[2]);
    if (!seconds) return seconds.error();
    if (*seconds < 0 || *seconds > 86400) return wrongArguments(words);
    request.seconds = *seconds;
  }
  return console.forEachRobot(
      [&](ConsoleRobot& robot) { return robot.observed().request(request); });
}

Result<void> ci(Console& console, const Words& words) {
  const bool on = words[1] == "on";
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (robot.index()) console.session().simulation().takeImages(*robot.index(), on);
    return {};
  });
}

Result<void> so(Console& console, const Words& words) {
  const bool on = words[1] == "on";
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    SimulatedRobot* const simulated = robot.simulated();
    return simulated ? simulated->giveTruth(on) : Result<void>{};
  });
}

Result<void> msg(Console& console, const Words& words) {
  const bool on = words[1] == "on";
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    robot.printsTexts = on;
    return {};
  });
}

Result<void> graph(Console& console, const Words& words) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const std::vector<ProcessDescription> modules = describe(**robot);
  if (words.size() == 2) {
    const std::string file = withDefaults(words[1], "out/graphs", ".svg");
    std::error_code ignored;  // then drawing reports what is wrong
    std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
    return writeSvg(drawModules(modules), file);
  }
  std::istringstream lines{describeModules(modules)};
  for (std::string line; std::getline(lines, line);) console.print(line);
  return {};
}

Result<void> layout(Console& console, const Words& words) {
  const std::string file = dataFile(console, words[1], "layouts", ".layout");
  const auto text = readFile(file);
  if (!text) return text.error();
  const auto parsed = parseLayout(*text, file);
  if (!parsed) return parsed.error();
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    return robot.observed().request(LayoutRequest{file, *text});
  });
}

}  // namespace

std::vector<std::string> drawingKeys(const std::string& name) {
  if (DebugKey::find(name)) return {name};
  for (const ReportKey& key : reportKeys())
    if (key.name == "send_" + name + "_drawing") return key.keys;
  return {};
}

std::vector<ProcessDescription> describe(ConsoleRobot& robot) {
  const auto processes = robot.observed().processes();
  return processes ? **processes : std::vector<ProcessDescription>{};
}

std::vector<Command> robotCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {
      {kind, "ci", "off | on",
       "Switches the calculation of images on (the default) or off: without, a simulated robot "
       "gets "
       "its last one again and again.",
       ci, nullptr, true},
      {kind, "dk", "? | KEY (off | on | NUMBER | every NUMBER [ms])",
       "Sets a debug key: never, always, so many times, every so many times or ms. The report's "
       "keys "
       "are accepted, too, and send with a representation's name: sendRobotPose.",
       dk, debugKeyNames, true},
      {kind, "graph", "[FILE]",
       "Prints which solution of each task runs and where what it reads comes from; draws it into "
       "out/graphs/ and with .svg if the file has none.",
       graph},
      {kind, "layout", "LAYOUT",
       "Regroups the modules to the processes of a layout, of layouts/ and with .layout if the "
       "file "
       "has no folder and extension.",
       layout, nullptr, true},
      {kind, "msg", "off | on", "Prints texts of the robots (the default), or not.", msg, nullptr},
      {kind, "qfr", "queue | replace | reject | collect SECONDS | save SECONDS",
       "Sets how the queue of messages to the tools is filled (by default queue).", qfr, nullptr,
       true},
      {kind, "sg", "? | ID {NUMBER}",
       "Sends up to ten numbers as generic debug data to the modules.", sg, idNames, true},
      {kind, "so", "off | on",
       "Gives the selected robots the truth or not (the default): with oracled world states, "
       "solutions Oracled can be chosen, and what disabled tasks would provide comes from the "
       "simulator.",
       so, nullptr, true},
      {kind, "sr", "? | TASK (? | SOLUTION)",
       "Has a task solved by another solution, or by none: disabled. On a log it runs on what was "
       "recorded: what the robot decided comes from the log then, unless BehaviorControl is "
       "switched on again.",
       sr, taskNames, true}};
}

}  // namespace gt
