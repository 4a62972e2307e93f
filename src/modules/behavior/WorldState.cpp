#include "modules/behavior/WorldState.h"

#include <algorithm>

namespace gt {

double estimatedTimeToReachBall(const WorldState& world) {
  constexpr double walkSpeed = 0.2, turnSpeed = 0.0015;  // mm/ms, rad/ms
  const Vector2d ball = world.knownBall();
  const Vector2d toGoal = world.opponentGoal() - world.knownBallOnField();
  const double wrongSide =
      std::abs(normalize(angleOf(toGoal) - world.self.pose.rotation - angleOf(ball)));
  return ball.norm() / walkSpeed + std::abs(angleOf(ball)) / turnSpeed +
         wrongSide * 200 / walkSpeed + 0.5 * static_cast<double>(world.knownBallAge());
}

DynamicRole negotiateRole(const WorldState& world, DynamicRole before) {
  if (world.player.role == PlayerRole::goalie) return DynamicRole::goalie;
  constexpr double advantage = 1500;  // ms
  const double own =
      estimatedTimeToReachBall(world) - (before == DynamicRole::striker ? advantage : 0);
  bool nearest = true, mostForward = true;
  world.forEachMate([&](const TeamMessage& mate) {
    if (mate.playerNumber == 1) return;  // the goalie
    const bool isStriker = mate.behavior.role == DynamicRole::striker;
    const double time = mate.behavior.estimatedTimeToReachBall - (isStriker ? advantage : 0);
    if (time < own || (time == own && mate.playerNumber < world.player.number())) nearest = false;
    if (!isStriker &&
        mate.robotPose.translation.x() >
            world.self.pose.translation.x() + (before == DynamicRole::offensiveSupporter ? 300 : 0))
      mostForward = false;
  });
  if (nearest) return DynamicRole::striker;
  return mostForward ? DynamicRole::offensiveSupporter : DynamicRole::defensiveSupporter;
}

double kickDirection(const WorldState& world) {
  const Vector2d ball = world.knownBallOnField();
  // Near the own goal: away from it, since a ball played across the goal's mouth is a present for
  // the opponent.
  const Vector2d fromOwnGoal = ball - world.ownGoal() + Vector2d{200, 0};
  if (fromOwnGoal.norm() < 900) return std::clamp(angleOf(fromOwnGoal), -1.2, 1.2);
  // A ball at the ground line beside the goal cannot be shot in: play it back before the goal.
  // The goalie guards the side on which the ball is, so aim a little to the other one.
  const Vector2d target{world.field.xGroundline + 100, -std::clamp(0.3 * ball.y(), -110.0, 110.0)};
  if (ball.x() > world.field.xGroundline - 250 && std::abs(ball.y()) > world.field.yGoal)
    return angleOf(Vector2d{world.field.xGroundline - 500, 0} - ball);
  return angleOf(target - ball);
}

double kickTolerance(const WorldState& world) {
  // A kick rolls some 2.5 m. From where it does not reach the goal, any way forward is a good one.
  const double distance = std::max((world.opponentGoal() - world.knownBallOnField()).norm(), 1.0);
  if (distance > 2600) return fromDegrees(25);
  return std::clamp(0.8 * std::atan2(world.field.yGoal - world.field.ballRadius, distance),
                    fromDegrees(5), fromDegrees(20));
}

}  // namespace gt
