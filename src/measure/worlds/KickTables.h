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

/// What the kicks of a folder's motions do, for the kinematic fidelity: the row of a table that was
/// measured with this motion, of the configuration or the project; without one it is measured, and
/// kept in the user's cache. Kicks are what the folder `kicks` of the motions has, or a table.
Result<KickTable> kicksOfMotions(const MotionNet& net, const ConfigurationPaths& paths,
                                 const DataRoot& root, unsigned threads);

/// The names of the kicks in a folder of motion descriptions: those in its subfolder `kicks`.
std::vector<std::string> kicksIn(const std::string& motions);

/// Formats a table as its file, config/kicks.cfg.
std::string kickTableText(const KickTable& table);

}  // namespace gt
