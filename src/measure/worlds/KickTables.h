#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/Result.h"
#include "measure/worlds/KickTrial.h"
#include "representations/motion/KickTable.h"
#include "representations/motion/MotionNet.h"
#include "robot/Configuration.h"

namespace gt {

/// Measures in the dynamic fidelity, with the profile `padova`, the effect of one of a folder's
/// motions on balls around the robot, with twelve robots that are built differently. The same input
/// yields the same output, with any number of threads.
Result<DescribedKick> measureKick(const std::string& motion, const MotionNet& net,
                                  const std::string& motions, const DataRoot& root,
                                  unsigned threads);

/// The effects of the kicks among a folder's motions, for the kinematic fidelity. Each is taken
/// from a row that was measured with the same motion: of the configuration's table, the project's,
/// or those that are kept of earlier teams (config/opponents). If there is none, the kick is
/// measured, and stored in the user's cache. Kicks are the motions in the subfolder `kicks`, or in
/// one of the first two tables.
Result<KickTable> kicksOfMotions(const MotionNet& net, const ConfigurationPaths& paths,
                                 const DataRoot& root, unsigned threads);

/// The names of the kicks in a folder of motion descriptions: those in its subfolder `kicks`.
std::vector<std::string> kicksIn(const std::string& motions);

/// Formats a table as its file, config/kicks.cfg.
std::string kickTableText(const KickTable& table);

}  // namespace gt
