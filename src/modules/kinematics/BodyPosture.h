#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// Height and inclination of the body above the ground.
struct BodyPosture {
  double height = 0;  ///< Height of the body's origin above the ground, mm.
  double tilt = 0;    ///< rad, positive: nose up.
  double roll = 0;    ///< rad, positive: right side down.

  BodyPosture operator+(const BodyPosture& other) const {
    return {height + other.height, tilt + other.tilt, roll + other.roll};
  }
};

/// Computes the body's posture from the joint angles on the assumption that roll is 0 and at least
/// one fore and one hind foot touch the ground, as the kinematic simulator does it (report 5.1.1).
BodyPosture bodyPosture(const RobotDimensions& robot, const JointAngles& angles);
/// Like above, with the offsets of a robot whose body leans otherwise than its joint angles show
/// (report B.4.5).
BodyPosture bodyPosture(const RobotDimensions& robot, const RobotCalibration& calibration,
                        const JointAngles& angles);

/// Computes the posture of a body at rest that may lie on its trunk or its knees. Gravity gives its
/// tilt and roll, its lowest point gives its height. `acceleration` is the measurement of the
/// acceleration sensors at rest (mm/s^2, in the body's axes).
BodyPosture restingPosture(const RobotDimensions& robot, const JointAngles& angles,
                           const Vector3d& acceleration);

/// The body's pose (mm) relative to the robot's origin, which lies on the ground below the body's
/// origin.
Pose3D bodyPose(const BodyPosture& posture);

}  // namespace gt
