#pragma once
#include <array>

#include "base/Geometry.h"

namespace gt {

/// A point of the body that can touch the ground: relative to the body's origin, with the radius of
/// the sphere around it (mm).
struct GroundPoint {
  Vector3d position = Vector3d::Zero();
  double radius = 0;
};

/// Height and tilt of the body above the ground.
struct Stance {
  double height = 0;  ///< mm: the body's origin above the ground
  double tilt = 0;    ///< rad, + nose up
};

/// Height and tilt with which at least one fore and one hind point touch the ground and none lies
/// below it, while the roll is zero (report 5.1.1). Feet, knees and the ends of the trunk are such
/// points, so that a lying robot does not sink in.
Stance stand(const std::array<GroundPoint, 5>& fore, const std::array<GroundPoint, 5>& hind,
             double previousTilt);

/// Height of a point's sphere above the ground (mm).
inline double clearance(const GroundPoint& point, const Stance& stance) {
  return stance.height + std::sin(stance.tilt) * point.position.x() +
         std::cos(stance.tilt) * point.position.z() - point.radius;
}

}  // namespace gt
