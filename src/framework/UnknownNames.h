#pragma once
#include <string>
#include <string_view>

#include "framework/SolutionTable.h"

namespace gt {

// What is wrong with a name of a task or of a solution that there is not, and which one was perhaps
// meant: "there is no such task; did you mean 'BallLocator'?"

std::string noSuchTask(const SolutionTable& table, std::string_view name);
std::string noSuchSolution(const Task& task, std::string_view name);

}  // namespace gt
