#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "base/Geometry.h"

namespace gt {

/// The footprint of a robot for collisions: the area that encloses two disks on its axis.
struct RobotFootprint {
  static constexpr double radius = 78;                      ///< mm
  static constexpr std::array<double, 2> middles{62, -55};  ///< x of the disks' centers, mm ahead
                                                            ///< of the robot's origin.

  /// The distance (mm) of a point relative to the robot (mm) from the boundary of this area;
  /// negative inside.
  static double distanceTo(const Vector2d& place) {
    const double onAxis = std::clamp(place.x(), middles[1], middles[0]);
    return std::hypot(place.x() - onAxis, place.y()) - radius;
  }
};

}  // namespace gt
