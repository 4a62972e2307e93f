#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Exit status and output of a program that has ended.
struct ProgramResult {
  int status = 0;  ///< Its exit status; negative if a signal ended it.
  std::string output, errors;
};

/// Runs a program that is searched in PATH, with these arguments and without a shell, passes it the
/// input, and waits until it ends. Returns an error if it cannot be started.
Result<ProgramResult> runProgram(const std::vector<std::string>& command,
                                 std::string_view input = {});

}  // namespace gt
