#include "modules/kinematics/HeadKinematics.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

double limited(Joint joint, double angle) {
  const auto limits = limitsOf(joint);
  return std::clamp(angle, limits.low, limits.high);
}

/// The point (mm) on the camera's ray through a pixel, before the neck turns, that is as far from
/// the tilt axis as the target.
Vector3d beamTo(const RobotDimensions& robot, const Vector3d& target, const Vector3d& ray) {
  const Vector3d start{robot.panToCamera, 0, robot.neckToPan};
  const double b = start.dot(ray) / ray.squaredNorm();
  const double c = (start.squaredNorm() - target.squaredNorm()) / ray.squaredNorm();
  // A target nearer than the camera has no solution; the ray of no length comes nearest.
  const double length = std::max(-b + std::sqrt(std::max(b * b - c, 0.0)), 0.0);
  return start + length * ray;
}

}  // namespace

Pose3D cameraInBody(const RobotDimensions& robot, const HeadAngles& head) {
  return Pose3D{}
      .translate(robot.neckX, 0, robot.neckZ)
      .rotate(rotationY(-head.tilt))
      .translate(0, 0, robot.neckToPan)
      .rotate(rotationZ(head.pan))
      .rotate(rotationX(head.roll))
      .translate(robot.panToCamera, 0, 0);
}

Pose3D cameraPose(const RobotDimensions& robot, const Pose3D& body, const HeadAngles& head) {
  return body * cameraInBody(robot, head);
}

HeadAngles lookAt(const RobotDimensions& robot, const Pose3D& body, const Vector3d& point,
                  const CameraInfo& camera, const Vector2d& pixel) {
  const Vector3d target = body.inverse() * point - Vector3d{robot.neckX, 0, robot.neckZ};
  const Vector3d beam = beamTo(robot, target, camera.ray(pixel.x(), pixel.y()));
  HeadAngles head;
  if (target.x() <= 0) {  // behind the neck: looked for over the shoulder, not over the head
    head.pan = limited(Joint::headPan, std::copysign(pi, target.y()));
    head.tilt =
        std::atan2(target.z(), std::hypot(target.x(), target.y())) - std::atan2(beam.z(), beam.x());
  } else {  // pan brings the beam's end to the target's y, tilt then turns it in the plane of x, z
    const double reach = std::hypot(beam.x(), beam.y());
    head.pan = limited(Joint::headPan, std::asin(std::clamp(target.y() / reach, -1.0, 1.0)) -
                                           std::atan2(beam.y(), beam.x()));
    const double ahead = std::cos(head.pan) * beam.x() - std::sin(head.pan) * beam.y();
    head.tilt = std::atan2(target.z(), target.x()) - std::atan2(beam.z(), ahead);
  }
  head.tilt = limited(Joint::headTilt, head.tilt);
  return head;
}

}  // namespace gt
