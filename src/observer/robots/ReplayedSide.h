#pragma once
#include <memory>
#include <string>
#include <vector>

#include "logs/LogComparison.h"
#include "observer/robots/LogRobot.h"

namespace gt {

/// A replayed log, possibly with other solutions of tasks, as a side of a comparison.
Result<std::unique_ptr<ComparedSide>> replayedSide(
    const std::string& log, const LogRobotOptions& options,
    const std::vector<Configuration::SolutionChoice>& solutions);

}  // namespace gt
