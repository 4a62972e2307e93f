#pragma once
#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The pose of the robot relative to its start, integrated from its own motion (report 3.9).
/// Provided by MotionControl.
struct OdometryData {
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{field<&OdometryData::pose>(Unit::mmRad, "pose relative to the start")};
  }
};

}  // namespace gt
