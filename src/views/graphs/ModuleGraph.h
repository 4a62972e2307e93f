#pragma once
#include <string>
#include <vector>

#include "framework/Description.h"

namespace gt {

/// The module graph of a running robot for people, from what its processes report about themselves:
/// which solution of each task runs, and where what it reads comes from. What no task provides
/// comes from outside: the platform or the configuration.
std::string describeModules(const std::vector<ProcessDescription>& robot);

/// The same as a drawing in Graphviz's language: a box for each task with the solution that runs,
/// dashed if that is none, an ellipse for each representation through which they hang together, a
/// frame for each process.
std::string drawModules(const std::vector<ProcessDescription>& robot);

}  // namespace gt
