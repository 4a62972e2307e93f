#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// How the body stands on its feet.
struct BodyPosture {
  double height = 0;  ///< mm, of the body's origin above the ground.
  double tilt = 0;    ///< rad, + nose up.
  double roll = 0;    ///< rad, + right side down.

  BodyPosture operator+(const BodyPosture& other) const {
    return {height + other.height, tilt + other.tilt, roll + other.roll};
  }
};

/// The body's posture from the joints, on the assumption that roll is 0 and at least one fore and
/// one hind foot touch the ground, as the kinematic simulator does it (report 5.1.1).
BodyPosture bodyPosture(const RobotDimensions& robot, const JointAngles& angles);
/// The same for a robot whose body leans otherwise than its joints measure (report B.4.5).
BodyPosture bodyPosture(const RobotDimensions& robot, const RobotCalibration& calibration,
                        const JointAngles& angles);

/// The posture of a body at rest that may lie on its trunk or its knees: gravity gives its tilt and
/// roll, the lowest point its height. `acceleration` is what its sensors feel at rest (mm/s^2, in
/// the body's axes).
BodyPosture restingPosture(const RobotDimensions& robot, const JointAngles& angles,
                           const Vector3d& acceleration);

/// The body's pose relative to the robot's origin, which lies on the ground below the body's.
Pose3D bodyPose(const BodyPosture& posture);

}  // namespace gt
