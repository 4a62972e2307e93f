#include "modules/behavior/skills/ContinuousBehaviors.h"

#include <cmath>

namespace gt {

void GoToPointContinuously::execute() {
  movement_.followField(movement_.tactics().world().fields.goToPoint, {fromDegrees(angle), {x, y}},
                        maxSpeed);
}

void GoToBallContinuously::execute() {
  const Tactics& tactics = movement_.tactics();
  const Pose2D& self = tactics.world().self.pose;
  const Vector2d ball = tactics.knownBall();
  const double wanted = fromDegrees(direction);
  // As an angle around the ball from the place behind it.
  const double around = normalize(angleOf(ball) + self.rotation - wanted);
  constexpr double behind = fromDegrees(25), near = 600;  // mm
  if (std::abs(around) < behind && ball.norm() < near) {
    lastPart_.direction = direction;
    lastPart_.x = x;
    lastPart_.y = y;
    return lastPart_.execute();
  }
  const Vector2d place =
      tactics.knownBallOnField() - gt::direction(wanted) * movement_.parameters().aroundBall;
  movement_.followField(tactics.world().fields.goToBall, {wanted, place}, 0);
}

void GoToOwnGoal::execute() {
  const WorldState& world = movement_.tactics().world();
  movement_.followField(world.fields.goToOwnGoal,
                        {fromDegrees(angle), {distance - world.field.xGroundline, 0}}, maxSpeed);
}

}  // namespace gt
