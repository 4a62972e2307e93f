#pragma once
#include <string>
#include <vector>

#include "framework/Description.h"

namespace gt {

/// Describes the module graph of a running robot, from its processes' descriptions of themselves:
/// the running solution of each task, and the sources of its inputs. Inputs that no task provides
/// come from outside: the platform or the configuration.
std::string describeModules(const std::vector<ProcessDescription>& robot);

/// The module graph as a drawing in Graphviz's language: a box for each task with the running
/// solution, dashed if none runs, an ellipse for each representation that connects tasks, a frame
/// for each process.
std::string drawModules(const std::vector<ProcessDescription>& robot);

}  // namespace gt
