#include <algorithm>
#include <cmath>
#include <set>

#include "console/Commands.h"
#include "streams/File.h"

namespace gt {
namespace {

/// What all processes of a robot say of themselves.
std::vector<ProcessDescription> describe(Robot& robot) {
  std::vector<ProcessDescription> all;
  for (const auto& process : robot.processes()) all.push_back(process->describe());
  return all;
}

/// Lines that the first selected robot has to tell.
template <typename Lines>
Result<void> list(Console& console, const Lines& linesOf) {
  const auto robots = console.selected();
  if (robots.empty()) return Error{"", 0, "robot", "no robot is selected"};
  for (const std::string& line : linesOf(*robots.front().robot)) console.world().print(line);
  return {};
}

Result<DebugRequest> debugRequest(const Words& words) {
  DebugRequest request{words[1], DebugKeyMode::disabled, 0};
  if (words.size() == 3 && words[2] == "off") return request;
  request.mode = DebugKeyMode::always;
  if (words.size() == 3 && words[2] == "on") return request;
  const bool every = words.size() > 3 && words[2] == "every";
  const bool ms = words.size() == 5 && words[4] == "ms";
  if (words.size() != (every ? (ms ? 5u : 4u) : 3u)) return wrongArguments(words);
  const auto n = numberOf(words[every ? 3 : 2]);
  if (!n) return n.error();
  if (*n < 1 || *n > 1e9 || *n != std::floor(*n)) return wrongArguments(words);
  request.n = static_cast<std::int64_t>(*n);
  request.mode = ms      ? DebugKeyMode::everyMs
                 : every ? DebugKeyMode::everyTimes
                         : DebugKeyMode::times;
  return request;
}

Result<void> dk(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?")
    return list(console, [](Robot& robot) {
      std::set<std::string> keys;
      for (const ProcessDescription& process : describe(robot))
        keys.insert(process.debugKeys.begin(), process.debugKeys.end());
      return keys;
    });
  if (words.size() < 3) return wrongArguments(words);
  const auto request = debugRequest(words);
  if (!request) return request.error();
  return console.forEachRobot([&](Robot& robot) { return robot.request(*request); });
}

Result<void> sr(Console& console, const Words& words) {
  if (words.size() == 2 && words[1] == "?")
    return list(console, [](Robot& robot) {
      std::vector<std::string> lines;
      for (const ProcessDescription& process : describe(robot))
        for (const TaskDescription& task : process.tasks)
          lines.push_back(task.name + " " + task.active);
      return lines;
    });
  if (words.size() != 3) return wrongArguments(words);
  if (words[2] == "?")
    return list(console, [&](Robot& robot) {
      std::vector<std::string> lines;
      for (const ProcessDescription& process : describe(robot))
        for (const TaskDescription& task : process.tasks)
          if (task.name == words[1]) {
            for (const SolutionDescription& solution : task.solutions)
              lines.push_back(solution.name);
            lines.emplace_back(SolutionTable::disabled);
          }
      return lines;
    });
  return console.forEachRobot([&](Robot& robot) {
    return robot.request(SolutionRequest{words[1], words[2]});
  });
}

Result<void> sg(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  GenericDebugData data{words[1], {}};
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto number = numberOf(words[i]);
    if (!number) return number.error();
    data.data.push_back(*number);
  }
  return console.forEachRobot([&](Robot& robot) { return robot.request(data); });
}

Result<void> qfr(Console& console, const Words& words) {
  if (words.size() < 2) return wrongArguments(words);
  const auto name = std::find(enumNames<QueueFillMode>.begin(), enumNames<QueueFillMode>.end(),
                              std::string_view{words[1]});
  if (name == enumNames<QueueFillMode>.end()) return wrongArguments(words);
  QueueFillRequest request;
  request.mode = static_cast<QueueFillMode>(name - enumNames<QueueFillMode>.begin());
  const bool timed = request.mode == QueueFillMode::collect || request.mode == QueueFillMode::save;
  if (words.size() != (timed ? 3u : 2u)) return wrongArguments(words);
  if (timed) {
    const auto seconds = numberOf(words[2]);
    if (!seconds) return seconds.error();
    if (*seconds < 0 || *seconds > 86400) return wrongArguments(words);
    request.seconds = *seconds;
  }
  return console.forEachRobot([&](Robot& robot) { return robot.request(request); });
}

/// TASK.SOLUTION.PATH, or TASK.PATH for the solution that runs.
struct ParameterName {
  std::string task, solution, path;
};

Result<ParameterName> parameterName(Robot& robot, const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == name.npos) return Error{"", 0, name, "expected TASK.PATH or TASK.SOLUTION.PATH"};
  ParameterName parameter{name.substr(0, dot), "", name.substr(dot + 1)};
  for (const auto& process : robot.processes()) {
    if (!process->solves(parameter.task)) continue;
    parameter.solution = process->activeSolution(parameter.task);
    for (const TaskDescription& task : process->describe().tasks)
      for (const SolutionDescription& solution : task.solutions)
        if (task.name == parameter.task && parameter.path.starts_with(solution.name + ".")) {
          parameter.solution = solution.name;
          parameter.path = parameter.path.substr(solution.name.size() + 1);
          return parameter;
        }
    return parameter;
  }
  return Error{"", 0, parameter.task, "no process solves this task"};
}

Result<void> get(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  for (const auto& [name, robot] : console.selected()) {
    if (words[1] == "?") {
      for (const ProcessDescription& process : describe(*robot))
        for (const TaskDescription& task : process.tasks)
          for (const SolutionDescription& solution : task.solutions)
            for (const ParameterDescription& p : solution.parameters)
              console.world().print(task.name + "." + solution.name + "." + p.path + " " + p.value +
                                    (p.unit.empty() ? "" : " " + p.unit) +
                                    (p.doc.empty() ? "" : "  // " + p.doc));
      return {};
    }
    const auto parameter = parameterName(*robot, words[1]);
    if (!parameter) return parameter.error();
    for (const auto& process : robot->processes()) {
      if (!process->solves(parameter->task)) continue;
      const auto value = process->parameter(parameter->task, parameter->solution, parameter->path);
      if (!value) return value.error();
      console.world().print(name + ": " + *value);
    }
  }
  return {};
}

Result<void> set(Console& console, const Words& words) {
  if (words.size() < 3) return wrongArguments(words);
  std::string value = words[2];
  for (std::size_t i = 3; i < words.size(); ++i) value += " " + words[i];
  return console.forEachRobot([&](Robot& robot) -> Result<void> {
    const auto parameter = parameterName(robot, words[1]);
    if (!parameter) return parameter.error();
    return robot.request(
        ParameterRequest{parameter->task, parameter->solution, parameter->path, value});
  });
}

Result<void> layout(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  const auto text = readFile(words[1]);
  if (!text) return text.error();
  // A wrong layout is told at once; a right one is taken with the robot's next step.
  const auto parsed = parseLayout(*text, words[1]);
  if (!parsed) return parsed.error();
  return console.forEachRobot([&](Robot& robot) -> Result<void> {
    if (const auto plan = robotPlan(*parsed, robot.platform()); !plan) return plan.error();
    robot.fromTools().write(console.world().time(), LayoutRequest{words[1], *text});
    return {};
  });
}

Result<void> behavior(Console& console, const Words& words) {
  if (words.size() != 2) return wrongArguments(words);
  return console.forEachRobot([&](Robot& robot) {
    return robot.request(BehaviorRequest{words[1], {}});
  });
}

}  // namespace

std::vector<Command> robotCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {{kind, "behavior", "FILE",
           "Goes on with a behavior, or with the same one after it was edited.", behavior},
          {kind, "dk", "? | KEY (off | on | NUMBER | every NUMBER [ms])",
           "Sets a debug key: never, always, so many times, every so many times or ms.", dk},
          {kind, "get", "? | TASK[.SOLUTION].PATH", "Prints a parameter, or all of them.", get},
          {kind, "layout", "FILE", "Regroups the modules to the processes of a layout.", layout},
          {kind, "qfr", "queue | replace | reject | collect SECONDS | save SECONDS",
           "Says how the queue of messages to the tools is filled.", qfr},
          {kind, "set", "TASK[.SOLUTION].PATH VALUE", "Sets a parameter.", set},
          {kind, "sg", "ID {NUMBER}", "Sends generic debug data to the modules.", sg},
          {kind, "sr", "? | TASK (? | SOLUTION)",
           "Has a task solved by another solution, or by none: disabled.", sr}};
}

}  // namespace gt
