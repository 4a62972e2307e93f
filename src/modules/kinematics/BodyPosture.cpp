#include "modules/kinematics/BodyPosture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

double heightOf(const Vector3d& foot, const BodyPosture& posture) {
  return posture.height + foot.x() * std::sin(posture.tilt) + foot.z() * std::cos(posture.tilt);
}

/// The posture in which two foot balls stand on the ground.
BodyPosture standingOn(const Vector3d& fore, const Vector3d& hind, double footRadius) {
  // Feet that pass each other leave the tilt without meaning: keep it finite.
  const double distance = std::max(fore.x() - hind.x(), 1.0);
  const double tilt = std::atan2(hind.z() - fore.z(), distance);
  return {footRadius - fore.x() * std::sin(tilt) - fore.z() * std::cos(tilt), tilt};
}

}  // namespace

BodyPosture bodyPosture(const RobotDimensions& robot, const JointAngles& angles) {
  const auto feet = footPositions(robot, angles);
  // Of the four pairs the body stands on the one that leaves no other foot below the ground.
  BodyPosture best;
  double bestDepth = std::numeric_limits<double>::max();
  for (const auto fore : {Leg::foreRight, Leg::foreLeft})
    for (const auto hind : {Leg::hindRight, Leg::hindLeft}) {
      const auto posture = standingOn(feet[static_cast<std::size_t>(fore)],
                                      feet[static_cast<std::size_t>(hind)], robot.footRadius);
      double depth = 0;
      for (const auto& foot : feet)
        depth = std::max(depth, robot.footRadius - heightOf(foot, posture));
      if (depth < bestDepth) {
        bestDepth = depth;
        best = posture;
      }
    }
  return best;
}

BodyPosture bodyPosture(const RobotDimensions& robot, const RobotCalibration& calibration,
                        const JointAngles& joints) {
  BodyPosture posture = bodyPosture(robot, joints);
  posture.tilt += calibration.bodyTiltOffset;
  posture.roll += calibration.bodyRollOffset;
  return posture;
}

Pose3D bodyPose(const BodyPosture& posture) {
  return {rotationX(posture.roll) * rotationY(-posture.tilt), {0, 0, posture.height}};
}

}  // namespace gt
