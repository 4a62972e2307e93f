#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "logs/LogComparison.h"
#include "observer/robots/LogRobot.h"

namespace gt {

/// One of two runs that are compared.
struct ComparedRun {
  std::string log;
  bool replayed = false;  ///< Whether the log is replayed; otherwise it is taken as recorded.
  std::string task{},
      solution{};  ///< Replayed with another solution of this task; empty: with none.
};

/// Compares two logs, or the outputs of modules for one log's inputs (`compareSides`). Has no side
/// effects; may be called by any thread. `progress` is called with the share that is done, and
/// returns false to stop.
Result<LogComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const LogRobotOptions& options,
                                  const std::function<bool(double share)>& progress);

/// Describes a comparison in a few lines: each representation that differs, and where it first
/// does.
std::vector<std::string> linesOf(const LogComparison& comparison);

/// All solutions of all tasks, including disabled.
std::map<std::string, std::vector<std::string>> allSolutions();

}  // namespace gt
