#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/logs/ReplayPlatform.h"

namespace gt {

/// What became of a recorded representation in a replay.
struct ReplayedTopic {
  std::string topic;
  std::uint64_t recorded = 0, replayed = 0;  ///< Messages.
  std::uint64_t different = 0;               ///< Of those at the same time.
  std::optional<std::int64_t> first;         ///< When they differ for the first time, ns.

  bool same() const { return recorded == replayed && different == 0; }
};

/// Replays a log, writes all that the robot computed into a new one, and compares what was
/// recorded.
Result<std::vector<ReplayedTopic>> replayLog(const ReplayOptions& options, const std::string& to);

}  // namespace gt
