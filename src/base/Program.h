#pragma once
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Runs a program of the path with these arguments, no shell in between, and returns what it
/// prints; what it complains of is dropped. An error if it is not there.
Result<std::string> outputOf(const std::vector<std::string>& command);

}  // namespace gt
