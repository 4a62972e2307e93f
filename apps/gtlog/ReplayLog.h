#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "logs/LogComparison.h"
#include "robot/replay/ReplayPlatform.h"

namespace gt {

/// By how much values may differ in a replay.
struct Tolerance {
  std::string path;  ///< A representation, or a value of it and all below: RobotPose.pose.
  double most = 0;   ///< Of numbers, in their unit; infinite: anything may differ or be missing.
};

/// Reads PATH=NUMBER. The path's first word must be a representation that logs hold.
Result<Tolerance> parseTolerance(const std::string& text);

/// What became of a recorded representation in a replay.
struct ReplayedTopic {
  std::string topic;
  std::uint64_t recorded = 0, replayed = 0;  ///< Messages.
  std::uint64_t different = 0;               ///< Of those at the same time.
  std::optional<std::uint64_t> first;        ///< When they differ for the first time, ns.
  std::vector<DifferentValue> values;        ///< In which they differ.
  bool within = true;                        ///< Whether it differs only as it may.

  bool same() const { return recorded == replayed && different == 0; }
};

struct ReplayReport {
  std::vector<ReplayedTopic> topics;
  std::vector<std::string> caveats;  ///< See ReplayPlatform.

  /// Whether all is the same, or within tolerances.
  bool within() const;
  /// A line for each topic.
  std::string text() const;
};

/// Replays a log, writes all that the robot computed into a new one, and compares what was
/// recorded. The new log is the same whenever and wherever that is done.
Result<ReplayReport> replayLog(const ReplayOptions& options, const std::string& to,
                               const std::vector<Tolerance>& tolerances = {});

}  // namespace gt
