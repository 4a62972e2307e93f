#include "modules/modeling/ball/RollingBall.h"

namespace gt {

RollingBall::Roll RollingBall::roll(double seconds, const State& state) const {
  const double speed = state.tail<2>().norm();
  if (speed == 0) return {seconds, 1};
  const double loss = deceleration * seconds;
  return loss < speed ? Roll{seconds, 1 - loss / speed} : Roll{speed / deceleration, 0};
}

RollingBall::State RollingBall::after(double seconds, const State& state) const {
  const Roll r = roll(seconds, state);
  State rolled = state;
  rolled.head<2>() += state.tail<2>() * (r.seconds * (1 + r.left) / 2);
  rolled.tail<2>() *= r.left;
  return rolled;
}

RollingBall::Derivative RollingBall::derivative(double seconds, const State& state) const {
  const Roll r = roll(seconds, state);
  const Eigen::Vector2d direction = state.tail<2>().normalized();  // 0 stays 0
  const Eigen::Matrix2d along = direction * direction.transpose();
  const Eigen::Matrix2d bySpeed = r.left * Eigen::Matrix2d::Identity() + (1 - r.left) * along;
  Derivative derivative = Derivative::Identity();
  derivative.topRightCorner<2, 2>() = r.seconds * (Eigen::Matrix2d::Identity() + bySpeed) / 2;
  derivative.bottomRightCorner<2, 2>() = bySpeed;
  if (r.left == 0) derivative.bottomRightCorner<2, 2>().setZero();
  return derivative;
}

}  // namespace gt
