#include "modules/behavior/tactics/RollingBall.h"

#include <cmath>

namespace gt {

std::optional<Crossing> crossingOf(const BallModel& ball, double deceleration) {
  const Vector2d& from = ball.position;
  const Vector2d& speed = ball.speed;
  if (from.x() <= 0 || speed.x() >= 0) return std::nullopt;
  const double share = from.x() / -speed.x();  // s, if it kept its speed
  const double fast = speed.norm(), length = share * fast;
  const double rest = fast * fast - 2 * deceleration * length;  // speed there, squared
  if (rest < 0) return std::nullopt;
  // As (fast - sqrt(rest)) / deceleration, without a division by 0.
  const double seconds = 2 * length / (fast + std::sqrt(rest));
  return Crossing{from.y() + share * speed.y(), 1000 * seconds};
}

}  // namespace gt
