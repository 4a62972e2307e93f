#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "base/Geometry.h"

namespace gt {

/// A robot seen from above: two discs on its axis, where it collides with others.
struct RobotFootprint {
  static constexpr double radius = 78;                      ///< mm
  static constexpr std::array<double, 2> middles{62, -55};  ///< mm ahead of the robot's origin.

  /// From the rim around both discs to a place relative to the robot (mm); less than 0 inside.
  static double distanceTo(const Vector2d& place) {
    const double onAxis = std::clamp(place.x(), middles[1], middles[0]);
    return std::hypot(place.x() - onAxis, place.y()) - radius;
  }
};

}  // namespace gt
