#pragma once
#include <cstdio>

#include "logs/LogSelection.h"

namespace gt {

/// Prints messages as JSON, one on each line: {"topic":…,"time":…,"message":…}, the time in
/// nanoseconds. At most `limit` of them, if that is not 0. The file's name is for errors. Returns
/// what was left out, since it cannot be read or the log is damaged.
Result<std::vector<Error>> exportJson(const std::string& log, const Selection& selection,
                                      std::FILE* to, const std::string& name,
                                      std::uint64_t limit = 0);

/// Writes one topic as CSV: a column for the time in seconds, and one for each path of a field.
/// Lists have as many columns as the longest of them needs; what a message lacks is empty. Returns
/// what was left out. Nothing is written if no message can be read.
Result<std::vector<Error>> exportCsv(const std::string& log, const Selection& selection,
                                     const std::string& topic, const std::string& to);

/// Writes what the behavior did as a file for `xabsl trace`. Returns what was left out.
Result<std::vector<Error>> exportTrace(const std::string& log, const Selection& selection,
                                       const std::string& to);

/// By the name of what is written: .json or .jsonl; .trace; .csv for one topic; else a folder with
/// a CSV file for each topic. Files are written whole or not at all. Returns what was left out,
/// such as topics that make no table.
Result<std::vector<Error>> exportLog(const std::string& log, const Selection& selection,
                                     const std::string& to);

}  // namespace gt
