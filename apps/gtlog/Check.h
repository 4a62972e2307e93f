#pragma once
#include <string>
#include <vector>

#include "logs/LogSelection.h"

namespace gt {

/// What a check of a log found.
struct LogCheck {
  std::uint64_t messages = 0;
  std::vector<Error> problems;
  /// Channels whose messages were not looked into: they are not CDR with a schema of ROS 2, which a
  /// log may well hold.
  std::vector<Error> unchecked;
};

/// Reads all of a log: checksums, index, and every message by its schema.
Result<LogCheck> checkLog(const std::string& path);

}  // namespace gt
