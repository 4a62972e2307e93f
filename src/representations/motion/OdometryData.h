#pragma once
#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// How far the robot has walked since its start, by its own motion model (report 3.9). Provided by
/// MotionControl.
struct OdometryData {
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{field<&OdometryData::pose>(Unit::mmRad, "where the start was the origin")};
  }
};

}  // namespace gt
