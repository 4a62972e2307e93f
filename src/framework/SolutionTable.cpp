#include "framework/SolutionTable.h"

#include <algorithm>
#include <utility>

#include "framework/UnknownNames.h"

namespace gt {

Result<void> SolutionTable::add(std::string_view task, Solution solution) {
  const auto known = tasks_.find(task);
  if (known == tasks_.end())
    return Error{.field = std::string{task}, .what = noSuchTask(*this, task)};
  const auto wrong = [&](std::string what) {
    return Error{.field = std::string{task}, .what = std::move(what)};
  };
  std::vector<const RepresentationType*> outputs;
  for (const Port& port : solution.ports)
    if (port.kind == PortKind::output) outputs.push_back(port.type);
  if (!std::ranges::is_permutation(outputs, known->second.outputs))
    return wrong("'" + solution.name + "' does not provide what the task provides");
  auto& all = known->second.solutions;
  const auto same = std::ranges::find(all, solution.name, &Solution::name);
  if (solution.name == disabled || (same != all.end() && !same->added))
    return wrong("has a solution '" + solution.name + "' already; choose another name");
  solution.added = true;
  if (same == all.end())
    all.push_back(std::move(solution));
  else
    *same = std::move(solution);
  return {};
}

}  // namespace gt
