#include "modules/behavior/skills/GoToBall.h"

#include <algorithm>
#include <cmath>

namespace gt {

void GoToBall::execute() {
  const Vector2d ball = movement_.tactics().knownBall();
  const double distance = ball.norm();
  const double facing =
      normalize(fromDegrees(direction) - movement_.tactics().world().self.pose.rotation);
  const Vector2d place = ball - rotated({x, y}, facing);
  // How far the robot is off the place behind the ball, as an angle around the ball.
  const double around = normalize(angleOf(-ball) - (facing + pi));
  const double maxSpeed = movement_.parameters().maxForward;
  if (std::abs(around) < fromDegrees(25) && distance < 600)
    return movement_.approach(place, facing, 0.8 * maxSpeed);

  // On a circle round the ball, from far away along its tangent, to the place behind the ball.
  const double most = distance > 400 ? fromDegrees(80) : fromDegrees(50);
  const double step = std::copysign(std::min(std::abs(around), most), around);
  const Vector2d next =
      ball + gt::direction(facing + pi + around - step) * movement_.parameters().aroundBall;
  // Near the ball obstacles do not count: they would win every duel (report 3.5.2, 3.8.2).
  if (distance > 700) return movement_.approachAvoiding(next, angleOf(next), maxSpeed);
  if (distance > 600) return movement_.approach(next, angleOf(next), maxSpeed);
  movement_.approach(next, distance > 350 ? angleOf(ball) : 0.5 * normalize(facing + angleOf(ball)),
                     maxSpeed);
}

}  // namespace gt
