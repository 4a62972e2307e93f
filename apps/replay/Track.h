#pragma once
#include <string>
#include <vector>

#include "base/Result.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/OdometryData.h"

namespace gt {

/// Where a robot believed to be over time, drawn on its field beside the way that its odometry
/// tells.
class Track {
 public:
  void add(const RobotPose& pose, const OdometryData& odometry) {
    poses_.push_back(pose);
    odometry_.push_back(odometry.pose);
  }

  /// Writes an image, .svg or .png. The odometry is laid so that it ends where the track does.
  Result<void> write(const std::string& path, const FieldDimensions& field) const;

 private:
  std::vector<RobotPose> poses_;
  std::vector<Pose2D> odometry_;
};

}  // namespace gt
