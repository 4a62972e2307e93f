#include "modules/motion/control/MotorLimits.h"

#include <algorithm>

#include "modules/kinematics/LegKinematics.h"

namespace gt {

void keepWithinLimits(JointAngles& angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto limits = limitsOf(static_cast<Joint>(i));
    angles.values[i] = std::clamp(angles.values[i], limits.low, limits.high);
  }
  for (const auto leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    angles[legJoint(leg, 2)] =
        std::max(angles[legJoint(leg, 2)], leastElevator(leg, angles[legJoint(leg, 1)]));
}

}  // namespace gt
