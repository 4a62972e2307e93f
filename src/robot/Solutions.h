#pragma once
#include "framework/SolutionTable.h"

namespace gt {

/// All tasks of the robot and all their solutions; the first of a task is its default (report,
/// chapter 3's table).
const SolutionTable& solutions();

}  // namespace gt
