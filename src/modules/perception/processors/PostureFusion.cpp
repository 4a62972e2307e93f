#include "modules/perception/processors/PostureFusion.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr double gravity = 9810;  // mm/s^2

double squared(double x) {
  return x * x;
}

}  // namespace

void PostureFusion::update(const BodyPosture& legs, const Vector3d& acceleration, double elapsed,
                           bool walks) {
  if (acceleration.squaredNorm() == 0) return;
  // The angles of bodyPose(): rotationX(roll) * rotationY(-tilt) turns the acceleration upright.
  const Vector2d felt{std::atan2(acceleration.x(), acceleration.z()),
                      std::atan2(acceleration.y(), std::hypot(acceleration.x(), acceleration.z()))};
  const Vector2d angle = felt - Vector2d{legs.tilt, legs.roll};
  // A body that is pushed or falls tells nothing of how it stands.
  constexpr double outlier = 3;  // standard deviations
  if (angle.norm() > outlier * parameters.disturbance) return;
  ++images_;
  // At first the mean of all there was. After a break no image counts for more than any other.
  constexpr double longest = 200;  // ms
  const double gain =
      std::max(1.0 / images_, std::clamp(elapsed, 0.0, longest) / parameters.memory);
  mean_ += gain * (angle - mean_);
  variance_ = squared(1 - gain) * variance_ + squared(gain * parameters.disturbance);
  const double lean = squared(parameters.lean);
  const double share = lean / (lean + squared(parameters.zero / gravity) + variance_);
  correction_ = share * mean_;
  if (walks) correction_ += parameters.swayShare * (angle - mean_);
}

}  // namespace gt
