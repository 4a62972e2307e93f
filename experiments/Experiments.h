#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "measure/Experiment.h"
#include "measure/Figures.h"

namespace gt {

/// All experiments, in the order of their names.
const Experiments& experiments();

/// Merges files of results and writes the figures to a file; beside it the page of the
/// self-locators, if they were measured, with a note at its top. What was dropped, and which jobs
/// of a list have no result, joins the warnings.
Result<Figures> mergeFiles(const std::vector<std::string>& files, const std::vector<Job>& jobs,
                           const std::string& json, std::vector<Error>& warnings,
                           const std::string& note = {});

/// The same walks in the kinematic and in the dynamic fidelity. Nothing in it is left to chance.
Experiment fidelityExperiment();
/// All self-locators: while a robot walks about for 18 minutes and how precisely it reaches points
/// (report 3.3.3.4, experiments 1 and 2); from nothing and after the robot was put somewhere else
/// (report 3.3.2.5); while beacons are missing, percepts are wrong, others are in the way.
Experiments localizationExperiments();
/// Whether simulated robots err as the real ones did: the report's published figures, measured with
/// the report's methods in each profile (docs/realism.md).
Experiments realismExperiments();
/// Whole matches: goals, own goals, localization against the truth.
Experiment matchExperiment();
/// How well teams play: against each other, without opponents, a striker alone, penalty shots.
Experiments playExperiments();
/// What a goalie alone does with balls that lie around it, and with shots.
Experiment goalieExperiment();
/// How robots move in the dynamic fidelity: whether they stand, how fast and straight they walk,
/// how often they fall.
Experiments motionExperiments();
/// Whether the robots see the ball, and what they know meanwhile, by each solution of HeadControl.
Experiments headExperiments();
/// The technical challenges of 2003, from random starts (report, chapter 4).
Experiments challengeExperiments();
/// What the kicks do, with balls anywhere where they reach them.
Experiment kickExperiment();
/// Whether a robot grabs the ball, turns with it and kicks it.
Experiment grabExperiment();
/// Whether robots stay on their feet during the special actions that are no kicks, or get up after
/// them.
Experiment showExperiment();
/// 22 robots and 10 balls while everything goes wrong: half an hour in the kinematic fidelity, some
/// minutes in the dynamic one.
Experiment soakExperiment();
/// Opening angles and body offsets from images of a checkerboard (report 3, B.4.5), and what a body
/// leans by from what is seen in play.
Experiments calibrationExperiments();
/// The image processors on random views of the simulated field.
Experiment visionExperiment();
/// The image processor that adapts its colors while robots play (report 6.2.1).
Experiment visionPlayExperiment();
/// Whether the strikers of a match see the ball, and why not.
Experiment visionSightExperiment();
/// Whether and how soon legs feel that the robot runs into something (report 3.6).
Experiment collisionExperiment();
/// What robots know of ball, obstacles and other players while they play (report 3.4 to 3.7).
Experiment worldModelExperiment();
/// How soon a robot knows that a ball rolls, and whether it keeps it in sight.
Experiment rollingExperiment();

/// Writes the configuration of both collision detectors in the root, fitted to the walks as they
/// are now.
Result<void> calibrateCollisions(const std::vector<std::uint64_t>& seeds, const DataRoot& root,
                                 unsigned threads);
/// Writes how bodies lean on legs that give, fitted to the walks as they are now.
Result<void> calibratePosture(const std::vector<std::uint64_t>& seeds, const DataRoot& root,
                              unsigned threads);
/// Measures what kicks of a team, or all of them, do with balls around them, and writes its table;
/// of the project, if the team has nothing of its own.
Result<void> calibrateKicks(const std::vector<std::string>& kicks, const std::string& team,
                            const DataRoot& root, unsigned threads);

}  // namespace gt
