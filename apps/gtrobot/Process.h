#pragma once
#include "robot/Solutions.h"

namespace gt {

/// Which process this program is, as the layouts name it. Generated from the layouts
/// (Generate.cpp).
extern const char* const processName;

/// All tasks, and the solutions of those that this process may run in some layout.
RobotModules processModules();

}  // namespace gt
