#pragma once
#include <string>

#include "base/DataRoot.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// Writes the present configuration of a running robot as a folder of configuration files (see
/// Configuration): solutions, their parameters, color table with the HSI ranges from which it was
/// made, TSL thresholds, camera settings, the calibration learned in play, dimensions of robot and
/// field. A robot can be started with that folder.
Result<void> saveRunningConfiguration(ObservedRobot& robot, const std::string& folder);

/// Applies the files of such a folder to a running robot. Missing files change nothing. Sections
/// for single robots are applied if they have the robot's hardware address. An error states file
/// and line; what was read before the error stays applied.
Result<void> loadRunningConfiguration(ObservedRobot& robot, const std::string& folder,
                                      const DataRoot& root);

}  // namespace gt
