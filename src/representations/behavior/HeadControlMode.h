#pragma once
#include "base/Enum.h"
#include "base/Geometry.h"
#include "representations/infrastructure/CameraInfo.h"
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
  lookRight,
  scanLeftRight,
  stayAsForced
};

/// Where the head shall look. Provided by BehaviorControl.
struct HeadControlMode {
  HeadMode mode = HeadMode::none;
  Vector3d point = Vector3d::Zero();
  Vector2d pixel{CameraInfo{}.centerX, CameraInfo{}.centerY};
  double scanTilt = -0.3;
  double scanRange = 1.45;

  static constexpr auto fields() {
    return Fields{
        field<&HeadControlMode::mode>(),
        field<&HeadControlMode::point>(Unit::mm,
                                       "for lookAtPoint: the point, relative to the robot"),
        field<&HeadControlMode::pixel>(
            Unit::pixel, "for lookAtPoint: where the point shall appear in the image"),
        field<&HeadControlMode::scanTilt>(
            Unit::rad, "for scanLeftRight: angle of the tilt joint, which is kept", {-1.5, 0.8}),
        field<&HeadControlMode::scanRange>(
            Unit::rad, "for scanLeftRight: how far the head turns to each side", {0, 1.6})};
  }
};

}  // namespace gt
