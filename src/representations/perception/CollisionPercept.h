#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// Whether the robot runs into something, as its legs feel it (report 3.6). Provided by the
/// CollisionDetector.
struct CollisionPercept {
  Time time;
  EnumArray<Leg, bool> legs;
  double strength = 0;
  Time lastCollision = never();

  bool collision() const { return lastCollision == time; }

  static constexpr auto fields() {
    return Fields{field<&CollisionPercept::time>(Unit::ms),
                  field<&CollisionPercept::legs>("that something holds up"),
                  field<&CollisionPercept::strength>(
                      "of the leg held up most: from 1 on that is a collision"),
                  field<&CollisionPercept::lastCollision>(Unit::ms)};
  }
};

}  // namespace gt
