#pragma once
#include <string>
#include <vector>

#include "motionnet/Diagnostic.h"
#include "motionnet/Net.h"

namespace motionnet {

/// Checks a linked net: whatever motion is requested, it is reached from every node, and every node
/// is reached. The files are those of the motions. Takes time in proportion to nodes times motions.
std::vector<Diagnostic> check(const Net& net, const std::vector<std::string>& files);

}  // namespace motionnet
