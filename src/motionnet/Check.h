#pragma once
#include <string>
#include <vector>

#include "motionnet/Diagnostic.h"
#include "motionnet/Net.h"

namespace motionnet {

/// Checks a linked net: each requested motion must be reached from every node, and every node must
/// be reachable. `files` are those of the motions. The time is proportional to nodes times motions.
std::vector<Diagnostic> check(const Net& net, const std::vector<std::string>& files);

}  // namespace motionnet
