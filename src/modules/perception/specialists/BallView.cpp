#include "modules/perception/specialists/BallView.h"

#include <cmath>

namespace gt {
namespace {

// Fuses the inverse distances, because the errors of distances grow with the square of the
// distance, while the inverse ones are equally accurate everywhere.
double fusedDistance(const BallPercept& percept, const BallCone& cone, double ballRadius,
                     const CameraMatrix& matrix) {
  constexpr double mostSmaller = 2.5;  // standard deviations, of a whole ball
  const double height = matrix.pose.translation.z() - ballRadius;
  const double cosine = std::hypot(cone.axis.x(), cone.axis.y());
  const double byProjection = 1 / percept.distanceByProjection;
  const double bySize = 1 / percept.distanceBySize;
  const double sizeError = std::cos(cone.angle) / ballRadius * cone.error;
  const double projectionError =
      std::sqrt(cosine * cosine * matrix.elevationVariance(azimuth(cone.axis)) +
                byProjection * byProjection * matrix.covariance(2, 2)) /
      height;
  // What hides a part of a ball makes it smaller, and never larger.
  const double smaller =
      (byProjection - bySize) / std::hypot(projectionError, sizeError) / mostSmaller;
  const double weight =
      std::pow(projectionError / sizeError, 2) / std::pow(std::max(smaller, 1.0), 4);
  return (1 + weight) / (byProjection + weight * bySize);
}

}  // namespace

bool describeBall(const CameraImage& picture, const BallCone& cone, double ballRadius,
                  BallPercept& percept) {
  constexpr double minRadius = 1.2;  // Pixels.
  const auto& [axis, angle, error] = cone;
  const double focal = focalLength(picture.matrix.info);
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
  const double distance = !projected ? percept.distanceBySize
                          : percept.distanceBySize == 0
                              ? percept.distanceByProjection
                              : fusedDistance(percept, cone, ballRadius, picture.matrix);
  if (distance <= 0) return false;
  // A ball on the ground is seen at the elevation that its distance has.
  const double lower = camera.z() - ballRadius;
  const bool corrected = projected && percept.distanceBySize > 0 && lower < distance;
  percept.angle = {azimuth(axis), corrected ? -std::asin(lower / distance) : elevation(axis)};
  percept.offset =
      camera.head<2>() + distance * std::cos(percept.angle.y()) * direction(percept.angle.x());
  if (angle == 0) percept.radiusInImage = focal * ballRadius / distance;
  return true;
}

// A ball neither floats nor sinks into the ground, nor reaches up to the horizon. At the distance
// that follows from its size, its center must be one radius above the ground.
bool isOnGround(const CameraImage& picture, const BallPercept& percept, const Vector3d& axis,
                double ballRadius) {
  if (!picture.matrix.valid) return true;
  if (elevation(axis) > fromDegrees(1)) return false;
  if (percept.distanceBySize == 0) return true;
  const double height = picture.matrix.pose.translation.z() + axis.z() * percept.distanceBySize;
  return std::abs(height - ballRadius) < 60 + 0.12 * percept.distanceBySize;
}

}  // namespace gt
