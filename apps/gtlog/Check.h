#pragma once
#include <string>
#include <vector>

#include "observer/LogSelection.h"

namespace gt {

/// What a check of a log found.
struct LogCheck {
  std::uint64_t messages = 0;
  std::vector<Error> problems;
};

/// Reads all of a log: checksums, index, and every message by its schema.
Result<LogCheck> checkLog(const std::string& path);

}  // namespace gt
