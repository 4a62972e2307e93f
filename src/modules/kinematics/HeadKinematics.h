#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/CameraInfo.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// The three angles of the neck in rad: positive tilt is up, positive pan is left, positive roll is
/// right ear down.
struct HeadAngles {
  double tilt = 0;
  double pan = 0;
  double roll = 0;
};

/// The camera's pose (mm) relative to the body, whose origin is midway between the shoulder axes
/// (report 3.1, steps 3 to 7). Camera: x along the optical axis, y left, z up.
Pose3D cameraInBody(const RobotDimensions& robot, const HeadAngles& head);

/// The camera's pose (mm) relative to the robot's origin on the ground (report 3.1): the body's
/// pose, then the seven steps. Step 1 also moves ahead by neckX, because the report's origin lies
/// below the neck and ours below the middle of the body.
Pose3D cameraPose(const RobotDimensions& robot, const Pose3D& body, const HeadAngles& head);

/// The angles of the neck with which a point (mm, relative to the robot) is seen at a pixel of the
/// image, with roll 0 (report 3.9.3.1). Exact if the neck can reach the angles; otherwise as near
/// as its limits allow, pan first.
HeadAngles lookAt(const RobotDimensions& robot, const Pose3D& body, const Vector3d& point,
                  const CameraInfo&, const Vector2d& pixel);

}  // namespace gt
