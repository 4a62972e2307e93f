#include "views/graphs/ModuleGraph.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "framework/SolutionTable.h"
#include "views/graphs/Graphviz.h"

namespace gt {
namespace {

constexpr const char* outside = "outside";

/// The task that provides each representation.
std::map<std::string, const TaskDescription*> providersOf(
    const std::vector<ProcessDescription>& robot) {
  std::map<std::string, const TaskDescription*> providers;
  for (const ProcessDescription& process : robot)
    for (const TaskDescription& task : process.tasks)
      for (const std::string& output : task.outputs) providers.emplace(output, &task);
  return providers;
}

/// The inputs of the running solution; empty if none runs.
std::vector<std::string> inputsOf(const TaskDescription& task) {
  const auto active = std::ranges::find(task.solutions, task.active, &SolutionDescription::name);
  return active == task.solutions.end() ? std::vector<std::string>{} : active->inputs;
}

bool isDisabled(const TaskDescription& task) {
  return task.active == SolutionTable::disabled;
}

/// The name of a representation's node, which differs from that of a task of the same name.
std::string nodeOf(const std::string& representation) {
  return dotQuoted("representation " + representation);
}

void drawProcess(const ProcessDescription& process, std::size_t number, std::ostream& dot) {
  dot << "  subgraph cluster" << number << " {\n    label=" << dotQuoted(process.process)
      << "; style=rounded; color=\"#9aa7b8\"; fontname=\"Helvetica\";\n";
  for (const TaskDescription& task : process.tasks) {
    dot << "    " << dotQuoted(task.name)
        << " [shape=box, label=" << dotQuoted(task.name + "\n" + task.active)
        << ", style=\"rounded,filled"
        << (isDisabled(task) ? ",dashed\", fillcolor=\"#f2f2f2\"" : "\", fillcolor=\"#d9e6f7\"")
        << "];\n";
    for (const std::string& output : task.outputs)
      dot << "    " << nodeOf(output) << " [label=" << dotQuoted(output) << "];\n";
  }
  dot << "  }\n";
}

}  // namespace

std::string describeModules(const std::vector<ProcessDescription>& robot) {
  const auto providers = providersOf(robot);
  std::ostringstream text;
  for (const ProcessDescription& process : robot) {
    text << "process " << process.process << '\n';
    for (const TaskDescription& task : process.tasks) {
      text << "  " << task.name << ' ' << task.active << '\n';
      for (const std::string& input : inputsOf(task)) {
        const auto provider = providers.find(input);
        text << "    <- " << input << " of ";
        if (provider == providers.end())
          text << outside << '\n';
        else
          text << provider->second->name << ' ' << provider->second->active << '\n';
      }
      for (const std::string& output : task.outputs) text << "    -> " << output << '\n';
    }
  }
  return text.str();
}

std::string drawModules(const std::vector<ProcessDescription>& robot) {
  const auto providers = providersOf(robot);
  std::ostringstream dot;
  dot << "digraph modules {\n  rankdir=LR; nodesep=0.15; ranksep=0.8;\n"
         "  node [shape=ellipse, fontname=\"Helvetica\", fontsize=11];\n"
         "  edge [color=\"#555555\"];\n";
  std::size_t number = 0;
  std::set<std::string> fromOutside;
  for (const ProcessDescription& process : robot) drawProcess(process, number++, dot);
  for (const ProcessDescription& process : robot)
    for (const TaskDescription& task : process.tasks) {
      for (const std::string& output : task.outputs)
        dot << "  " << dotQuoted(task.name) << " -> " << nodeOf(output)
            << (isDisabled(task) ? " [style=dashed];\n" : ";\n");
      for (const std::string& input : inputsOf(task)) {
        if (!providers.contains(input)) fromOutside.insert(input);
        dot << "  " << nodeOf(input) << " -> " << dotQuoted(task.name) << ";\n";
      }
    }
  for (const std::string& input : fromOutside)
    dot << "  " << nodeOf(input) << " [label=" << dotQuoted(input)
        << ", style=filled, fillcolor=\"#f3ecd8\"];\n";
  dot << "}\n";
  return dot.str();
}

}  // namespace gt
