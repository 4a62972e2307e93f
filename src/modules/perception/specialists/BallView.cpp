#include "modules/perception/specialists/BallView.h"

#include <cmath>

namespace gt {

bool describeBall(const CameraImage& picture, const Vector3d& axis, double angle, double ballRadius,
                  BallPercept& percept) {
  constexpr double minRadius = 1.2;  // Pixels.
  const double focal = focalLength(picture.matrix.info);
  percept.angle = {azimuth(axis), elevation(axis)};
  percept.centerInImage = picture.pointOf(axis);
  percept.radiusInImage = std::tan(angle) * focal;
  if (angle > 0) {
    if (percept.radiusInImage < minRadius) return false;
    percept.distanceBySize = ballRadius / std::sin(angle);
  }
  // Where the ray meets the plane through the ball's center.
  const Vector3d camera = picture.matrix.pose.translation;
  constexpr double flattest = 0.01, farthest = 10000;
  if (axis.z() < -flattest && camera.z() > ballRadius)
    percept.distanceByProjection = (ballRadius - camera.z()) / axis.z();
  if (percept.distanceByProjection > farthest) percept.distanceByProjection = 0;
  const bool projected = picture.matrix.valid && percept.distanceByProjection > 0;
  const double distance = projected ? percept.distanceByProjection : percept.distanceBySize;
  if (distance <= 0) return false;
  percept.offset = (camera + axis * distance).head<2>();
  if (angle == 0) percept.radiusInImage = focal * ballRadius / distance;
  return true;
}

// A ball neither floats nor lies deep in the ground, nor does it ever reach up to the horizon: seen
// at the distance that follows from its size, its center is at its radius above the ground.
bool isOnGround(const CameraImage& picture, const BallPercept& percept, const Vector3d& axis,
                double ballRadius) {
  if (!picture.matrix.valid) return true;
  if (elevation(axis) > fromDegrees(1)) return false;
  if (percept.distanceBySize == 0) return true;
  const double height = picture.matrix.pose.translation.z() + axis.z() * percept.distanceBySize;
  return std::abs(height - ballRadius) < 60 + 0.12 * percept.distanceBySize;
}

}  // namespace gt
