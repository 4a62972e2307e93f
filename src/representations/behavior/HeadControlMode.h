#pragma once
#include "base/Enum.h"
#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The head control modes (report 3.9.3.1, facts 4).
enum class HeadMode {
  none,
  lookAtPoint,
  searchForLandmarks,
  searchForBall,
  searchAuto,
  lookStraightAhead,
  lookLeft,
  lookRight
};

/// Where the head shall look. Provided by BehaviorControl.
struct HeadControlMode {
  HeadMode mode = HeadMode::none;
  Vector3d point = Vector3d::Zero();

  static constexpr auto fields() {
    return Fields{
        field("mode", &HeadControlMode::mode),
        field("point", &HeadControlMode::point, "mm", "for lookAtPoint, in the robot's system")};
  }
};

}  // namespace gt
