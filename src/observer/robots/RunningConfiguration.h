#pragma once
#include <string>

#include "base/DataRoot.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// Writes what a robot works with now, wherever it runs, as a folder of configuration files (see
/// Configuration): solutions, their parameters, color table with the HSI ranges of which it was
/// made, TSL thresholds, settings of the camera, calibration as it was learned in play, dimensions
/// of robot and field. A robot can be started with that folder.
Result<void> saveRunningConfiguration(ObservedRobot& robot, const std::string& folder);

/// Has a running robot work with what such a folder holds. Files that are missing there change
/// nothing; of sections for single robots, those of its hardware address hold. An error names file
/// and line; what was read before it, holds.
Result<void> loadRunningConfiguration(ObservedRobot& robot, const std::string& folder,
                                      const DataRoot& root);

}  // namespace gt
