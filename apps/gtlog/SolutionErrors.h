#pragma once
#include <string>
#include <vector>

#include "robot/replay/ReplayPlatform.h"

namespace gt {

/// How wrong a robot on a log is with one solution of a task: distances to the truth that a
/// simulator recorded (/OracledWorldState), one for each image while the game runs.
struct SolutionErrors {
  std::string solution;
  std::vector<double> position;  ///< Of the robot on the field, mm.
  std::vector<double> rotation;  ///< Of the robot, rad.
  std::vector<double> ball;      ///< Of the ball relative to the robot, in images that show it, mm.
};

/// Replays a log with each of these solutions of a task. An error if the log holds no truth, or if
/// one of them cannot be chosen.
Result<std::vector<SolutionErrors>> compareSolutions(const ReplayOptions& options,
                                                     const std::string& task,
                                                     const std::vector<std::string>& solutions);

/// A table of text: a line for each solution, with means and medians.
std::string tableOf(const std::string& task, const std::vector<SolutionErrors>& errors);

}  // namespace gt
