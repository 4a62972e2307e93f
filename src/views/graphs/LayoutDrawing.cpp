#include "views/graphs/LayoutDrawing.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "robot/Robot.h"
#include "views/graphs/Graphviz.h"

namespace gt {
namespace {

constexpr const char* platformName = "Platform";

/// All types that one process sends to another.
struct Arrow {
  std::vector<std::string> types;
  std::string trigger;  ///< The type that starts a cycle; empty if none does.
};
using Arrows = std::map<std::pair<std::string, std::string>, Arrow>;

std::string nameOf(const std::string& process) {
  return process.empty() ? platformName : process;
}

/// The arrows between processes, including the robot's commands to its platform and the message
/// queues.
Arrows arrowsOf(const Plan& plan) {
  Arrows arrows;
  for (const Connection& connection : plan.connections) {
    Arrow& arrow = arrows[{nameOf(connection.from), nameOf(connection.to)}];
    arrow.types.emplace_back(connection.type->name);
    if (connection.blocking) arrow.trigger = connection.type->name;
  }
  for (const Plan::Process& process : plan.processes) {
    for (const Plan::Step& step : process.order)
      for (const RepresentationType* type : step.task->outputs)
        if (isCommand(*type))
          arrows[{process.layout.name, platformName}].types.emplace_back(type->name);
    if (!process.layout.collectsMessages) continue;
    for (const Plan::Process& other : plan.processes)
      if (!other.layout.collectsMessages) {
        arrows[{other.layout.name, process.layout.name}].types = {"MessageQueue"};
        arrows[{process.layout.name, other.layout.name}].types = {"MessageQueue"};
      }
  }
  return arrows;
}

std::string join(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// A process as a table of HTML, which Graphviz accepts as a label. The process's name is escaped;
/// names of tasks hold letters only.
std::string labelOf(const Plan::Process& process) {
  std::ostringstream label;
  const auto escaped = [](const std::string& text) {
    std::string result;
    for (const char c : text)
      result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
  };
  label << "<<table border=\"0\" cellspacing=\"0\" cellpadding=\"3\"><tr><td><b>"
        << escaped(process.layout.name) << "</b><br/><font point-size=\"10\">on "
        << escaped(process.layout.trigger) << "</font></td></tr>";
  for (const Plan::Step& step : process.order) {
    label << "<tr><td align=\"left\">" << step.task->name;
    if (step.trigger)
      label << " <font point-size=\"9\" color=\"#777777\">on " << step.trigger->name << "</font>";
    label << "</td></tr>";
  }
  label << "</table>>";
  return label.str();
}

}  // namespace

std::string describePlan(const Plan& plan) {
  std::ostringstream text;
  for (const Plan::Process& process : plan.processes) {
    text << "process " << process.layout.name << " on " << process.layout.trigger << '\n';
    for (std::size_t i = 0; i < process.order.size(); ++i) {
      const auto& [task, trigger] = process.order[i];
      text << "  " << (i < 9 ? " " : "") << i + 1 << ". " << task->name;
      if (trigger) text << " on " << trigger->name;
      std::vector<std::string> outputs;
      for (const RepresentationType* type : task->outputs) outputs.emplace_back(type->name);
      text << ": " << join(outputs, ", ") << '\n';
    }
  }
  text << "crosses\n";
  for (const auto& [ends, arrow] : arrowsOf(plan)) {
    text << "  " << ends.first << " -> " << ends.second << ": " << join(arrow.types, ", ");
    if (!arrow.trigger.empty()) text << "; " << arrow.trigger << " starts a cycle";
    text << '\n';
  }
  return text.str();
}

std::string drawPlan(const Plan& plan) {
  std::ostringstream dot;
  dot << "digraph layout {\n  rankdir=LR; nodesep=0.5; ranksep=1.6;\n"
         "  node [shape=box, style=\"rounded,filled\", fillcolor=\"#eef3fa\", "
         "fontname=\"Helvetica\", fontsize=12];\n"
         "  edge [fontname=\"Helvetica\", fontsize=9, color=\"#555555\"];\n"
      << "  " << dotQuoted(platformName) << " [shape=cylinder, fillcolor=\"#f3ecd8\"];\n";
  for (const Plan::Process& process : plan.processes)
    dot << "  " << dotQuoted(process.layout.name) << " [label=" << labelOf(process)
        << (process.layout.collectsMessages ? ", style=\"rounded,dashed\"" : "") << "];\n";
  for (const auto& [ends, arrow] : arrowsOf(plan)) {
    const bool messages = arrow.types.front() == "MessageQueue";
    // Message queues go both ways: one line for both.
    if (messages && ends.first > ends.second) continue;
    dot << "  " << dotQuoted(ends.first) << " -> " << dotQuoted(ends.second) << " [label=\""
        << join(arrow.types, "\\n") << '"' << (arrow.trigger.empty() ? "" : ", penwidth=2.5")
        << (messages ? ", style=dashed, dir=both" : "") << "];\n";
  }
  dot << "}\n";
  return dot.str();
}

}  // namespace gt
