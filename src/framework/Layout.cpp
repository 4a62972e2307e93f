#include "framework/Layout.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "streams/File.h"

namespace gt {
namespace {

using Types = std::vector<const RepresentationType*>;

bool contains(const Types& types, const RepresentationType* type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

std::vector<std::string> words(std::string line) {
  for (const char* comment : {"//", "#"})
    if (const auto at = line.find(comment); at != line.npos) line.resize(at);
  std::istringstream stream{line};
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

/// What a task's solutions read in this cycle, over all of them.
Types inputsOf(const Task& task, PortKind kind) {
  Types types;
  for (const Solution& solution : task.solutions)
    for (const Port& port : solution.ports)
      if (port.kind == kind && !contains(types, port.type)) types.push_back(port.type);
  return types;
}

/// Where each representation is provided.
struct Provider {
  std::string process;
  std::string task;
};
using Providers = std::map<const RepresentationType*, Provider>;

Result<void> checkTrigger(const ProcessLayout& process, const std::string& file,
                          const Types& platform) {
  const bool known = process.collectsMessages ||
                     std::any_of(platform.begin(), platform.end(),
                                 [&](auto* type) { return type->name == process.trigger; });
  if (!known)
    return Error{file, process.line, process.name,
                 "'" + process.trigger + "' is not sent by the platform"};
  return {};
}

Result<Providers> findProviders(const Layout& layout, const SolutionTable& table,
                                const Types& platform) {
  Providers providers;
  std::set<std::string> seen;
  for (const ProcessLayout& process : layout.processes) {
    if (const auto ok = checkTrigger(process, layout.file, platform); !ok) return ok.error();
    for (std::size_t i = 0; i < process.tasks.size(); ++i) {
      const std::string& name = process.tasks[i];
      const int line = process.taskLines[i];
      const Task* task = table.find(name);
      if (!task) return Error{layout.file, line, name, "there is no such task"};
      if (!seen.insert(name).second) return Error{layout.file, line, name, "is listed twice"};
      for (const RepresentationType* output : task->outputs) {
        const auto [other, added] = providers.insert({output, {process.name, name}});
        if (!added)
          return Error{layout.file, line, name,
                       std::string{output->name} + " is already provided by " + other->second.task};
      }
    }
  }
  return providers;
}

/// Sorts a process's tasks so that each runs after those whose outputs it reads; otherwise the
/// file's order holds.
Result<std::vector<const Task*>> sort(const ProcessLayout& process, const Layout& layout,
                                      const SolutionTable& table, const Providers& providers) {
  std::vector<const Task*> waiting, order;
  for (const std::string& name : process.tasks) waiting.push_back(table.find(name));
  const auto isFree = [&](const Task* task) {
    for (const RepresentationType* input : inputsOf(*task, PortKind::input)) {
      const auto provider = providers.find(input);
      if (provider == providers.end() || provider->second.process != process.name ||
          provider->second.task == task->name)
        continue;
      if (std::none_of(order.begin(), order.end(),
                       [&](auto* done) { return done->name == provider->second.task; }))
        return false;
    }
    return true;
  };
  while (!waiting.empty()) {
    const auto next = std::find_if(waiting.begin(), waiting.end(), isFree);
    if (next == waiting.end()) {
      std::string names;
      for (const Task* task : waiting) names += " " + task->name;
      return Error{layout.file, process.line, process.name,
                   "a circle of modules that wait for each other, among:" + names};
    }
    order.push_back(*next);
    waiting.erase(next);
  }
  return order;
}

}  // namespace

Result<Layout> parseLayout(std::string_view text, const std::string& file) {
  Layout layout{file, {}};
  std::istringstream stream{std::string{text}};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::vector<std::string> list = words(line);
    if (list.empty()) continue;
    if (list[0] == "process") {
      if (list.size() != 4 || list[2] != "on")
        return Error{file, number, "process",
                     "expected: process NAME on REPRESENTATION, or: process NAME on messages"};
      for (const ProcessLayout& other : layout.processes)
        if (other.name == list[1])
          return Error{file, number, list[1], "there are two processes of this name"};
      layout.processes.push_back({list[1], list[3], list[3] == "messages", {}, number, {}});
    } else if (list.size() != 1) {
      return Error{file, number, list[0], "expected one task in a line"};
    } else if (layout.processes.empty()) {
      return Error{file, number, list[0], "stands before the first process"};
    } else if (layout.processes.back().collectsMessages) {
      return Error{file, number, list[0], "a process that collects messages runs no modules"};
    } else {
      layout.processes.back().tasks.push_back(list[0]);
      layout.processes.back().taskLines.push_back(number);
    }
  }
  if (layout.processes.empty()) return Error{file, number, "process", "there is none"};
  return layout;
}

Result<Layout> loadLayout(const std::string& file) {
  const auto text = readFile(file);
  return text ? parseLayout(*text, file) : text.error();
}

Result<Plan> makePlan(const Layout& layout, const SolutionTable& table, const Types& platform,
                      const Types& given) {
  const auto providers = findProviders(layout, table, platform);
  if (!providers) return providers.error();
  Plan plan;
  for (const ProcessLayout& process : layout.processes) {
    const auto order = sort(process, layout, table, *providers);
    if (!order) return order.error();
    plan.processes.push_back({process, *order});
    Types connected;
    for (const RepresentationType* type : platform)
      if (type->name == process.trigger) {
        plan.connections.push_back({type, "", process.name, true});
        connected.push_back(type);
      }
    for (std::size_t i = 0; i < process.tasks.size(); ++i)
      for (const PortKind kind : {PortKind::input, PortKind::previous})
        for (const RepresentationType* type : inputsOf(*table.find(process.tasks[i]), kind)) {
          if (contains(connected, type) || contains(given, type)) continue;
          const auto provider = providers->find(type);
          const bool here =
              provider != providers->end() && provider->second.process == process.name;
          if (here) continue;
          if (provider == providers->end() && !contains(platform, type))
            return Error{layout.file, process.taskLines[i], process.tasks[i],
                         "nobody provides its " + std::string{type->name}};
          plan.connections.push_back({type,
                                      provider == providers->end() ? "" : provider->second.process,
                                      process.name, false});
          connected.push_back(type);
        }
  }
  return plan;
}

}  // namespace gt
