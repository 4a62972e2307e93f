#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The pose of the robot on the field (mm, rad), in the coordinates of its own team (report 3.3).
/// Provided by the SelfLocator.
struct RobotPose {
  Pose2D pose;
  double validity = 0;

  static constexpr auto fields() {
    return Fields{field<&RobotPose::pose>(Unit::mmRad),
                  field<&RobotPose::validity>("certainty of the pose, report (3.16)", {0, 1})};
  }
};

}  // namespace gt
