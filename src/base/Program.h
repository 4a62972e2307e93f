#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"

namespace gt {

/// What a program that has ended left behind.
struct ProgramResult {
  int status = 0;  ///< Its exit status; negative if a signal ended it.
  std::string output, errors;
};

/// Runs a program of the path with these arguments, no shell in between, gives it the input, and
/// waits until it ends. An error if it cannot be started.
Result<ProgramResult> runProgram(const std::vector<std::string>& command,
                                 std::string_view input = {});

}  // namespace gt
