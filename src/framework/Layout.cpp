#include "framework/Layout.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/File.h"
#include "base/Lines.h"
#include "framework/LayoutCheck.h"
#include "framework/UnknownNames.h"

namespace gt {
namespace {

using Types = std::vector<const RepresentationType*>;
using Errors = Findings;

bool contains(const Types& types, const RepresentationType* type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// All representations that at least one solution of a task reads in this cycle.
Types inputsOf(const Task& task, PortKind kind) {
  Types types;
  for (const Solution& solution : task.solutions)
    for (const Port& port : solution.ports)
      if (port.kind == kind && !contains(types, port.type)) types.push_back(port.type);
  return types;
}

/// Whether a robot on this platform can do without a representation that is not provided: no task
/// of any layout provides it, and only solutions that need not be selected read it.
bool isDispensable(const Task& task, const RepresentationType* type, const SolutionTable& table) {
  const auto reads = [&](const Solution& solution) {
    return std::ranges::any_of(solution.ports, [&](const Port& port) {
      return port.kind != PortKind::output && port.type == type;
    });
  };
  return std::ranges::none_of(
             table.tasks(),
             [&](const auto& other) { return contains(other.second.outputs, type); }) &&
         std::ranges::none_of(task.solutions, [&](const Solution& solution) {
           return (&solution == &task.solutions.front() || solution.added) && reads(solution);
         });
}

/// The provider of a representation.
struct Provider {
  std::string process;
  const ProcessLayout::Group* group;
  std::string task;
};
using Providers = std::map<const RepresentationType*, Provider>;

/// Leaves out tasks that are unknown or listed twice.
Providers findProviders(const Layout& layout, const SolutionTable& table, Errors& errors) {
  Providers providers;
  std::set<std::string> seen;
  for (const ProcessLayout& process : layout.processes)
    for (const ProcessLayout::Group& group : process.groups)
      for (std::size_t i = 0; i < group.tasks.size(); ++i) {
        const std::string& name = group.tasks[i];
        const int line = group.taskLines[i];
        const Task* task = table.find(name);
        if (!task || !seen.insert(name).second) {
          errors.add({.file = layout.file,
                      .line = line,
                      .field = name,
                      .what = task ? "is listed twice" : noSuchTask(table, name)});
          continue;
        }
        for (const RepresentationType* output : task->outputs) {
          const auto [other, added] = providers.insert({output, {process.name, &group, name}});
          if (!added)
            errors.add({.file = layout.file,
                        .line = line,
                        .field = name,
                        .what = std::string{output->name} + " is already provided by " +
                                other->second.task});
        }
      }
  return providers;
}

/// Representations are distinguished by their names, and their messages by ids made of these.
void checkNames(const Layout& layout, const SolutionTable& table, const Types& platform,
                const Types& given, Errors& errors) {
  std::map<std::string_view, const RepresentationType*> names;
  std::map<std::uint32_t, const RepresentationType*> ids;
  const auto check = [&](const RepresentationType* type) {
    const RepresentationType* named = names.try_emplace(type->name, type).first->second;
    const RepresentationType* numbered = ids.try_emplace(type->id, type).first->second;
    for (const RepresentationType* other : {named, numbered})
      if (other != type)
        return errors.add({.file = layout.file,
                           .field = std::string{type->name},
                           .what = "cannot be distinguished: " + std::string{other->qualifiedName} +
                                   " and " + std::string{type->qualifiedName} + "; rename one"});
  };
  std::set<const RepresentationType*> all{platform.begin(), platform.end()};
  all.insert(given.begin(), given.end());
  for (const auto& [name, task] : table.tasks()) {
    all.insert(task.outputs.begin(), task.outputs.end());
    for (const Solution& solution : task.solutions)
      for (const Port& port : solution.ports) all.insert(port.type);
  }
  for (const RepresentationType* type : all) check(type);
}

/// Sorts a group's tasks so that each runs after those whose outputs it reads; otherwise the
/// file's order holds.
class Sorter {
 public:
  Sorter(const ProcessLayout::Group& group, const SolutionTable& table, const Providers& providers)
      : group_{group}, providers_{providers} {
    for (const std::string& name : group.tasks)
      if (const Task* task = table.find(name)) waiting_.push_back(task);
  }

  /// The tasks in their order, up to a circle of tasks that wait for each other.
  std::vector<const Task*> sort() {
    std::vector<const Task*> order;
    while (!waiting_.empty()) {
      const auto next = std::ranges::find_if(
          waiting_, [&](const Task* task) { return !firstMissing(*task).type; });
      if (next == waiting_.end()) break;
      order.push_back(*next);
      waiting_.erase(next);
    }
    return order;
  }

  /// The circle that was found, as a sentence; empty if there is none.
  std::string circle() const {
    if (waiting_.empty()) return {};
    // Each waiting task waits for another one: following them leads into the circle.
    const Task* task = waiting_.front();
    for (std::size_t i = 0; i < waiting_.size(); ++i) task = firstMissing(*task).provider;
    std::string text = "a circle of tasks that wait for each other:";
    const Task* const begin = task;
    do {
      const Missing missing = firstMissing(*task);
      text += (task == begin ? " " : ", ") + task->name + " reads " +
              std::string{missing.type->name} + " of " + missing.provider->name;
      task = missing.provider;
    } while (task != begin);
    return text + "; Previous<> breaks it";
  }

 private:
  struct Missing {
    const RepresentationType* type = nullptr;
    const Task* provider = nullptr;
  };

  /// The first input that a task of the group still has to provide.
  Missing firstMissing(const Task& task) const {
    for (const RepresentationType* input : inputsOf(task, PortKind::input)) {
      const auto provider = providers_.find(input);
      if (provider == providers_.end() || provider->second.group != &group_ ||
          provider->second.task == task.name)
        continue;
      for (const Task* other : waiting_)
        if (other->name == provider->second.task) return {input, other};
    }
    return {};
  }

  const ProcessLayout::Group& group_;
  const Providers& providers_;
  std::vector<const Task*> waiting_;
};

/// Computes the inputs of one process.
class Connector {
 public:
  Connector(const Layout& layout, const ProcessLayout& process, const Providers& providers,
            const Types& platform)
      : layout_{layout}, process_{process}, providers_{providers}, platform_{platform} {}

  /// The type of the trigger of a cycle or a group. Returns an error if it is not sent from outside
  /// the process.
  Result<const RepresentationType*> trigger(const std::string& name, int line, bool blocking) {
    for (const auto& [type, provider] : providers_)
      if (type->name == name && provider.process != process_.name) return add(type, blocking);
    for (const RepresentationType* type : platform_)
      if (type->name == name && !providers_.contains(type)) return add(type, blocking);
    return Error{.file = layout_.file,
                 .line = line,
                 .field = process_.name,
                 .what = "'" + name + "' is sent neither by the platform nor by another process"};
  }
  /// Adds an input of a task; returns false if it is not provided.
  bool input(const RepresentationType* type) {
    const auto provider = providers_.find(type);
    if (provider != providers_.end() && provider->second.process == process_.name) return true;
    if (provider == providers_.end() && !contains(platform_, type)) return false;
    add(type, false);
    return true;
  }
  const std::vector<Connection>& connections() const { return connections_; }

 private:
  const RepresentationType* add(const RepresentationType* type, bool blocking) {
    for (const Connection& connection : connections_)
      if (connection.type == type) return type;
    const auto provider = providers_.find(type);
    connections_.push_back({type, provider == providers_.end() ? "" : provider->second.process,
                            process_.name, blocking});
    return type;
  }

  const Layout& layout_;
  const ProcessLayout& process_;
  const Providers& providers_;
  const Types& platform_;
  std::vector<Connection> connections_;
};

/// The plan of one process; appends to the connections of all.
Plan::Process planProcess(const ProcessLayout& process, const Layout& layout,
                          const SolutionTable& table, const Providers& providers,
                          const Types& platform, const Types& given,
                          std::vector<Connection>& connections, Errors& errors) {
  Plan::Process plan{process, {}, {}, {}, {}};
  Connector connector{layout, process, providers, platform};
  const auto trigger = [&](const std::string& name, int line,
                           bool blocking) -> const RepresentationType* {
    const auto type = connector.trigger(name, line, blocking);
    if (type) return *type;
    errors.add(type.error());
    return nullptr;
  };
  if (!process.collectsMessages) trigger(process.trigger, process.line, true);
  for (const ProcessLayout::Group& group : process.groups) {
    const RepresentationType* type =
        group.trigger.empty() ? nullptr : trigger(group.trigger, group.line, false);
    Sorter sorter{group, table, providers};
    for (const Task* task : sorter.sort()) plan.order.push_back({task, type});
    if (std::string circle = sorter.circle(); !circle.empty())
      errors.add({.file = layout.file,
                  .line = group.line,
                  .field = process.name,
                  .what = std::move(circle)});
    for (std::size_t i = 0; i < group.tasks.size(); ++i)
      for (const PortKind kind : {PortKind::input, PortKind::previous})
        if (const Task* task = table.find(group.tasks[i]))
          for (const RepresentationType* input : inputsOf(*task, kind))
            if (!contains(given, input) && !connector.input(input)) {
              if (isDispensable(*task, input, table))
                plan.missing.push_back(input);
              else
                errors.add({.file = layout.file,
                            .line = group.taskLines[i],
                            .field = group.tasks[i],
                            .what = "nobody provides its " + std::string{input->name}});
            }
  }
  for (const Connection& connection : connector.connections()) {
    if (connection.from.empty()) plan.platform.push_back(connection.type);
    if (!connection.type->decode)
      errors.add(
          {.file = layout.file,
           .line = process.line,
           .field = process.name,
           .what = std::string{connection.type->name} + " comes from " +
                   (connection.from.empty() ? "the platform" : "process " + connection.from) +
                   ", but cannot be sent: it has no fields()"});
  }
  connections.insert(connections.end(), connector.connections().begin(),
                     connector.connections().end());
  return plan;
}

/// One line of a layout file, without its comment.
Result<void> parseLine(const std::vector<Word>& words, int number, Layout& layout) {
  std::vector<std::string> list;
  for (const Word& word : words) list.push_back(word.text);
  const auto wrong = [&](std::string field, std::string what) {
    return Error{
        .file = layout.file, .line = number, .field = std::move(field), .what = std::move(what)};
  };
  if (list[0] == "process") {
    if (list.size() != 4 || list[2] != "on")
      return wrong("process",
                   "expected: process NAME on REPRESENTATION, or: process NAME on messages");
    for (const ProcessLayout& other : layout.processes)
      if (other.name == list[1])
        return wrong(list[1], "there are two processes of this name");
      else if (other.collectsMessages && list[3] == "messages")
        return wrong(list[1], "process " + other.name + " collects messages already");
    layout.processes.push_back({list[1], list[3], list[3] == "messages", {}, number});
    layout.processes.back().groups.push_back({"", {}, {}, number});
    return {};
  }
  if (list.size() > 2 || (list.size() == 2 && list[0] != "on"))
    return wrong(list[0], "expected one task in a line");
  if (layout.processes.empty()) return wrong(list[0], "stands before the first process");
  ProcessLayout& process = layout.processes.back();
  if (process.collectsMessages)
    return wrong(list[0], "a process that collects messages runs no modules");
  if (list.size() == 2) {
    process.groups.push_back({list[1] == "cycle" ? "" : list[1], {}, {}, number});
  } else {
    process.groups.back().tasks.push_back(list[0]);
    process.groups.back().taskLines.push_back(number);
  }
  return {};
}

Layout parseAll(std::string_view text, const std::string& file, Errors& errors) {
  Layout layout{file, {}};
  int last = 0;
  for (const Line& line : linesOf(text)) {
    last = line.number;
    const auto words = wordsOf(line.text);
    if (!words)
      errors.add({.file = file, .line = line.number, .what = words.error().what});
    else
      errors.add(parseLine(*words, line.number, layout));
  }
  if (layout.processes.empty())
    errors.add({.file = file, .line = last, .field = "process", .what = "there is none"});
  return layout;
}

/// Decides which process answers tools about a representation that no module provides.
void assignAnswers(Plan& plan, const Types& given) {
  const auto answersFor = [&](const RepresentationType* type) -> const Plan::Process& {
    const auto begins = std::ranges::find_if(
        plan.processes, [&](const auto& process) { return process.layout.trigger == type->name; });
    return begins != plan.processes.end()
               ? *begins
               : *std::ranges::find_if(plan.processes, [&](const auto& process) {
                   return contains(process.platform, type);
                 });
  };
  bool first = true;
  for (Plan::Process& process : plan.processes) {
    if (process.layout.collectsMessages) continue;
    for (const Plan::Step& step : process.order)
      process.answersFor.insert(process.answersFor.end(), step.task->outputs.begin(),
                                step.task->outputs.end());
    for (const RepresentationType* type : process.platform)
      if (&answersFor(type) == &process) process.answersFor.push_back(type);
    if (std::exchange(first, false))
      process.answersFor.insert(process.answersFor.end(), given.begin(), given.end());
  }
}

Plan planAll(const Layout& layout, const SolutionTable& table, const Types& platform,
             const Types& given, Errors& errors) {
  checkNames(layout, table, platform, given, errors);
  const Providers providers = findProviders(layout, table, errors);
  Plan plan;
  plan.file = layout.file;
  for (const ProcessLayout& process : layout.processes)
    plan.processes.push_back(
        planProcess(process, layout, table, providers, platform, given, plan.connections, errors));
  assignAnswers(plan, given);
  return plan;
}

}  // namespace

bool Plan::has(std::string_view representation) const {
  return std::ranges::any_of(processes, [&](const Process& process) {
    return std::ranges::find(process.answersFor, representation, &RepresentationType::name) !=
           process.answersFor.end();
  });
}

Result<Layout> parseLayout(std::string_view text, const std::string& file) {
  Errors errors;
  Layout layout = parseAll(text, file, errors);
  if (auto done = errors.firstError(); !done) return done.error();
  return layout;
}

Result<Layout> loadLayout(const std::string& file) {
  const auto text = readFile(file);
  return text ? parseLayout(*text, file) : text.error();
}

Result<Plan> makePlan(const Layout& layout, const SolutionTable& table, const Types& platform,
                      const Types& given) {
  Errors errors;
  Plan made = planAll(layout, table, platform, given, errors);
  if (auto done = errors.firstError(); !done) return done.error();
  return made;
}

Findings checkLayoutText(std::string_view text, const std::string& file, const SolutionTable& table,
                         const Types& platform, const Types& given) {
  Errors errors;
  const Layout layout = parseAll(text, file, errors);
  planAll(layout, table, platform, given, errors);
  return errors;
}

}  // namespace gt
