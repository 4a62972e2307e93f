#pragma once
#include "logs/LogSelection.h"

namespace gt {

/// How a log is written again.
struct Transferred {
  std::uint64_t messages = 0;
  std::vector<Error> lost;  ///< Where something could not be read.
};

/// Writes the selected messages, with all metadata and attachments, into a new log.
Result<Transferred> cutLog(const std::string& from, const Selection& selection,
                           const std::string& to);

/// Joins logs by time. Metadata are distinguished by the files' names where there are several,
/// topics by the robots' names where these differ: /red1/BallModel.
Result<Transferred> joinLogs(const std::vector<std::string>& from, const std::string& to);

/// Writes all that is whole in a damaged log into a new one with an index.
Result<Transferred> repairLog(const std::string& from, const std::string& to);

}  // namespace gt
