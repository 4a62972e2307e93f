#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "Figures.h"
#include "base/Result.h"

namespace gt {

/// What all experiments are asked for.
struct ExperimentOptions {
  std::vector<std::uint64_t> seeds;
  double minutes = 10;      ///< Of a match.
  int moments = 250;        ///< For vision, per seed: each gives one picture a robot.
  bool ceiling = false;     ///< For the world model: truth from a ceiling camera, not the oracle.
  std::string ceilingLogs;  ///< Folder for its logs; none are written if empty.
  bool trueCamera = false;  ///< For vision: the true camera pose instead of the measured one.
};

/// Whole matches: goals, own goals, localization against the truth.
Result<void> measureMatches(Figures& figures, const ExperimentOptions& options);
/// All self-locators while a robot walks about for 18 minutes (report 3.3.3.4, experiment 1).
Result<void> measureWalks(Figures& figures, const ExperimentOptions& options);
/// From nothing, and after the robot was put somewhere else (report 3.3.2.5).
Result<void> measureSearch(Figures& figures, const ExperimentOptions& options);
/// While beacons are missing, percepts are wrong, others are in the way.
Result<void> measureRobustness(Figures& figures, const ExperimentOptions& options);
/// How precisely points are reached (report 3.3.3.4, experiment 2).
Result<void> measureGoToPoint(Figures& figures, const ExperimentOptions& options);
/// The image processor on random views of the simulated field.
Result<void> measureVision(Figures& figures, const ExperimentOptions& options);
/// The image processor that adapts its colours while robots play (report 6.2.1).
Result<void> measureVisionPlay(Figures& figures, const ExperimentOptions& options);
/// Opening angles and body offsets from pictures of a checkerboard (report 3, B.4.5).
Result<void> measureCalibration(Figures& figures, const ExperimentOptions& options);
/// 22 robots and 10 balls while everything goes wrong: half an hour in the kinematic fidelity, some
/// minutes in the dynamic one.
Result<void> measureSoak(Figures& figures, const ExperimentOptions& options);
/// What robots know of ball, obstacles and other players while they play (report 3.4 to 3.7).
Result<void> measureWorldModel(Figures& figures, const ExperimentOptions& options);
/// Whether and how soon legs feel that the robot runs into something (report 3.6).
Result<void> measureCollisions(Figures& figures, const ExperimentOptions& options);
/// Writes the thresholds of the collision detector into its configuration, for the gaits as they
/// are now, from walks in which nothing is touched.
Result<void> calibrateCollisions(const ExperimentOptions& options);
/// The same walks in the kinematic and in the dynamic fidelity. Nothing in it is left to chance.
Result<void> measureFidelity(Figures& figures, const ExperimentOptions& options);

}  // namespace gt
