#include "framework/UnknownNames.h"

#include "base/Suggestion.h"

namespace gt {

std::string noSuchTask(const SolutionTable& table, std::string_view name) {
  std::vector<std::string> known;
  for (const auto& [task, described] : table.tasks()) known.push_back(task);
  return "there is no such task" + suggestion(name, known);
}

std::string noSuchSolution(const Task& task, std::string_view name) {
  return "there is no solution '" + std::string{name} + "'" +
         suggestion(name, namesIn(task.solutions));
}

}  // namespace gt
