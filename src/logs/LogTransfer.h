#pragma once
#include "logs/LogSelection.h"

namespace gt {

/// The result of rewriting a log.
struct Transferred {
  std::uint64_t messages = 0;
  std::vector<Error> lost;  ///< Parts that could not be read.
};

/// Writes the selected messages, with all metadata and attachments, into a new log.
Result<Transferred> cutLog(const std::string& from, const Selection& selection,
                           const std::string& to);

/// Merges logs by time. If there are several logs, metadata are distinguished by the files' names.
/// If the robots' names differ, topics are distinguished by them: /red1/BallModel.
Result<Transferred> joinLogs(const std::vector<std::string>& from, const std::string& to);

/// Copies all undamaged parts of a log into a new one with an index.
Result<Transferred> repairLog(const std::string& from, const std::string& to);

}  // namespace gt
