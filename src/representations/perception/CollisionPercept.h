#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// Collisions of the robot, detected from the motion of its legs (report 3.6). Provided by the
/// CollisionDetector.
struct CollisionPercept {
  Time time;
  EnumArray<Leg, bool> legs;
  double strength = 0;
  Time lastCollision = never();

  bool collision() const { return lastCollision == time; }

  static constexpr auto fields() {
    return Fields{field<&CollisionPercept::time>(Unit::ms),
                  field<&CollisionPercept::legs>("whether something obstructs each leg"),
                  field<&CollisionPercept::strength>(
                      "strength at the most obstructed leg; from 1 on it is a collision"),
                  field<&CollisionPercept::lastCollision>(Unit::ms)};
  }
};

}  // namespace gt
