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
  // How far the robot is off the place from which the ball lies so, as an angle around the ball.
  const double behind = facing + pi + angleOf(Vector2d{x, y});
  const double around = normalize(angleOf(-ball) - behind);
  const double maxSpeed = movement_.parameters().maxForward;
  if (std::abs(around) < fromDegrees(25) && distance < 600)
    return movement_.approach(place, facing, movement_.parameters().nearForward);

  // On a circle round the ball, from far away along its tangent.
  const double most = distance > 400 ? fromDegrees(80) : fromDegrees(50);
  const double step = std::copysign(std::min(std::abs(around), most), around);
  const Vector2d next =
      ball + gt::direction(behind + around - step) * movement_.parameters().aroundBall;
  // Near the ball obstacles do not count: they would win every duel (report 3.5.2, 3.8.2).
  if (distance > 700) return movement_.approachAvoiding(next, angleOf(next), maxSpeed);
  if (distance > 600) return movement_.approach(next, angleOf(next), maxSpeed);
  movement_.approach(next, distance > 350 ? angleOf(ball) : 0.5 * normalize(facing + angleOf(ball)),
                     maxSpeed);
}

}  // namespace gt
