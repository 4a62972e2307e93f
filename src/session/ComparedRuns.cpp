#include "session/ComparedRuns.h"

#include <cstdio>
#include <utility>

#include "observer/robots/ReplayedSide.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

Result<std::unique_ptr<ComparedSide>> sideOf(const ComparedRun& run,
                                             const LogRobotOptions& options) {
  if (!run.replayed) return recordedSide(run.log);
  std::vector<Configuration::SolutionChoice> solutions;
  if (!run.task.empty()) solutions.push_back({run.task, run.solution, "", 0});
  return replayedSide(run.log, options, solutions);
}

}  // namespace

Result<LogComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const LogRobotOptions& options,
                                  const std::function<bool(double share)>& progress) {
  const auto first = sideOf(a, options);
  if (!first) return first.error();
  const auto second = sideOf(b, options);
  if (!second) return second.error();
  return compareSides(**first, **second, progress);
}

std::vector<std::string> linesOf(const LogComparison& comparison) {
  std::vector<std::string> lines;
  for (const Error& lost : comparison.lost) lines.push_back(lost.text());
  std::size_t same = 0;
  for (const ComparedTopic& topic : comparison.topics) {
    if (topic.same()) {
      ++same;
      continue;
    }
    char text[160];
    std::snprintf(text, sizeof text, ": differs at %llu of %llu times",
                  static_cast<unsigned long long>(topic.different),
                  static_cast<unsigned long long>(topic.compared));
    std::string line = (topic.input ? "input " : "") + topic.name + text;
    if (topic.onlyA + topic.onlyB > 0) {
      std::snprintf(text, sizeof text, ", only in A %llu, only in B %llu",
                    static_cast<unsigned long long>(topic.onlyA),
                    static_cast<unsigned long long>(topic.onlyB));
      line += text;
    }
    const DifferentValue* first = nullptr;
    for (const DifferentValue& value : topic.values)
      if (!first || value.first < first->first) first = &value;
    if (first) {
      std::snprintf(text, sizeof text,
                    "; first at %.3f s: ", static_cast<double>(first->first.ms) / 1000);
      line += text + first->path + " = " + first->firstA + " and " + first->firstB;
    }
    lines.push_back(std::move(line));
  }
  lines.push_back(std::to_string(same) + " of " + std::to_string(comparison.topics.size()) +
                  " representations are the same" +
                  (comparison.stopped ? ", until it was stopped" : ""));
  return lines;
}

std::map<std::string, std::vector<std::string>> allSolutions() {
  std::map<std::string, std::vector<std::string>> all;
  for (const auto& [name, task] : solutions().tasks()) {
    auto& list = all[std::string{name}];
    for (const auto& solution : task.solutions) list.push_back(solution.name);
    list.emplace_back(SolutionTable::disabled);
  }
  return all;
}

}  // namespace gt
