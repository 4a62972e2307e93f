#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "logs/LogComparison.h"
#include "observer/robots/LogRobot.h"

namespace gt {

/// One of two sides that a person compares.
struct ComparedRun {
  std::string log;
  bool replayed = false;  ///< Otherwise it is taken as it was recorded.
  std::string task{},
      solution{};  ///< Replayed with another solution of this task; empty: with none.
};

/// Compares two logs, or what modules make of one log's inputs (`compareSides`). Changes nothing,
/// and may be called by any thread.
Result<LogComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const LogRobotOptions& options,
                                  const std::function<bool(double share)>& progress);

/// A few lines about a comparison: each representation that differs, and where it does first.
std::vector<std::string> linesOf(const LogComparison& comparison);

/// All solutions of all tasks, disabled among them.
std::map<std::string, std::vector<std::string>> allSolutions();

}  // namespace gt
