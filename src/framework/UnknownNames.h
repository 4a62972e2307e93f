#pragma once
#include <string>
#include <string_view>

#include "framework/SolutionTable.h"

namespace gt {

// Errors about unknown names of tasks and solutions, with a suggestion: "there is no such task; did
// you mean 'BallLocator'?"

std::string noSuchTask(const SolutionTable& table, std::string_view name);
std::string noSuchSolution(const Task& task, std::string_view name);

}  // namespace gt
