#pragma once
#include "robot/Areas.h"

namespace gt {

/// Which process this program is, as the layouts name it. Generated from the layouts
/// (Generate.cpp).
extern const char* const processName;

/// Adds the areas whose tasks this process may run in some layout.
void addProcessModules(RobotModules& modules);

}  // namespace gt
