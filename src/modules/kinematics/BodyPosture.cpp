#include "modules/kinematics/BodyPosture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

/// A body that stands on two foot balls.
struct Stance {
  double tilt, sine, cosine, height;

  Stance(const Vector3d& fore, const Vector3d& hind, double footRadius) {
    // Feet that pass each other leave the tilt without meaning: keep it finite.
    const double distance = std::max(fore.x() - hind.x(), 1.0);
    tilt = std::atan2(hind.z() - fore.z(), distance);
    sine = std::sin(tilt);
    cosine = std::cos(tilt);
    height = footRadius - fore.x() * sine - fore.z() * cosine;
  }
  double heightOf(const Vector3d& foot) const {
    return height + foot.x() * sine + foot.z() * cosine;
  }
};

/// Points on which a lying body rests (models/ers210.xml), relative to the body: the fore end of
/// its trunk with a radius, the hind end; and the radius of the knees (mm).
const Vector3d chest{66, 0, -12}, rump{-82, 0, -38};
constexpr double chestRadius = 28, kneeRadius = 14;

}  // namespace

BodyPosture bodyPosture(const RobotDimensions& robot, const JointAngles& angles) {
  const auto feet = footPositions(robot, angles);
  // Of the four pairs the body stands on the one that leaves no other foot below the ground.
  BodyPosture best;
  double bestDepth = std::numeric_limits<double>::max();
  for (const auto fore : {Leg::foreRight, Leg::foreLeft})
    for (const auto hind : {Leg::hindRight, Leg::hindLeft}) {
      const Stance stance{feet[static_cast<std::size_t>(fore)],
                          feet[static_cast<std::size_t>(hind)], robot.footRadius};
      double depth = 0;
      for (const auto& foot : feet)
        depth = std::max(depth, robot.footRadius - stance.heightOf(foot));
      if (depth < bestDepth) {
        bestDepth = depth;
        best = {stance.height, stance.tilt};
      }
    }
  return best;
}

BodyPosture bodyPosture(const RobotDimensions& robot, const RobotCalibration& calibration,
                        const JointAngles& joints) {
  return bodyPosture(robot, joints) + BodyPosture{calibration.bodyHeightOffset,
                                                  calibration.bodyTiltOffset,
                                                  calibration.bodyRollOffset};
}

BodyPosture restingPosture(const RobotDimensions& robot, const JointAngles& angles,
                           const Vector3d& acceleration) {
  BodyPosture posture;
  posture.tilt = std::atan2(acceleration.x(), acceleration.z());
  posture.roll = std::atan2(acceleration.y(), std::hypot(acceleration.x(), acceleration.z()));
  const Matrix3d upright = bodyPose(posture).rotation;
  double lowest = std::min((upright * chest).z() - chestRadius, (upright * rump).z());
  const auto reach = [&](const Vector3d& point, double radius) {
    lowest = std::min(lowest, (upright * point).z() - radius);
  };
  for (const auto leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    reach(footPosition(robot, leg, legOf(angles, leg)), robot.footRadius);
    reach(kneePosition(robot, leg, legOf(angles, leg)), kneeRadius);
  }
  posture.height = -lowest;
  return posture;
}

Pose3D bodyPose(const BodyPosture& posture) {
  return {rotationX(posture.roll) * rotationY(-posture.tilt), {0, 0, posture.height}};
}

}  // namespace gt
