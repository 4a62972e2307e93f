#include "modules/behavior/tactics/WorldState.h"

#include <algorithm>

namespace gt {

void WorldState::addMatesToObstacles() {
  constexpr double halfWidth = 80;
  for (const LocatedPlayer& mate : players.ownTeam) {
    if (mate.number == 0) continue;
    const Vector2d middle = relative(self.pose, mate.position);
    const double distance = std::max(middle.norm(), 1.0);
    const Vector2d away = middle / distance, aside = rotated(away, pi / 2);
    const Vector2d front = middle - away * std::min(halfWidth, distance / 2);
    for (const double part : {-1., -0.5, 0., 0.5, 1.})
      obstacles.enter(front + part * halfWidth * aside, true, mate.lastSeen);
  }
}

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

namespace {

/// Whether a robot that stands behind the ball and faces a direction has room between the walls.
bool hasRoom(const FieldDimensions& field, const Vector2d& ball, double facing) {
  constexpr double clearance = 85;                       // of the body's sides
  const Vector2d back = ball - direction(facing) * 205;  // the middle of the hind part
  const bool insideWalls = std::abs(back.x()) < field.xGroundline - clearance &&
                           std::abs(back.y()) < field.ySideline - clearance;
  const double corner =
      (field.xGroundline - std::abs(back.x())) + (field.ySideline - std::abs(back.y()));
  return insideWalls && corner > field.xGroundline - field.xSideCorner + clearance * 1.4;
}

/// The direction nearest to a wanted one in which other robots do not stop the ball at once; before
/// the goal, to the middle of its free part (report 3.8.2).
double pastObstacles(const WorldState& world, double wanted) {
  constexpr double handled = 700, shot = 1600, ballsWay = 180, soon = 500;  // mm
  const Vector2d ball = world.knownBall();
  if (ball.norm() > handled) return wanted;  // nobody knows what is there
  const double toField = world.self.pose.rotation;
  const Vector2d left = relative(world.self.pose, {world.field.xGroundline, world.field.yGoal});
  const Vector2d right = relative(world.self.pose, {world.field.xGroundline, -world.field.yGoal});
  if (((left + right) / 2 - ball).norm() < shot)
    if (const auto part = world.obstacles.freeGoalPart(ball, left, right, ballsWay)) {
      const double all = normalize(angleOf(left - ball) - angleOf(right - ball));
      if (part->width < 0.8 * all) return normalize(part->middle + toField);
    }
  constexpr double most = fromDegrees(40);
  const auto way =
      world.obstacles.freeDirection(normalize(wanted - toField), ballsWay, soon, most, ball);
  return way ? normalize(*way + toField) : wanted;
}

/// Where the ball should go if there were no walls.
double wantedDirection(const WorldState& world) {
  const Vector2d ball = world.knownBallOnField();
  // Near the own goal: away from it, since a ball played across the goal's mouth is a present for
  // the opponent.
  const Vector2d fromOwnGoal = ball - world.ownGoal() + Vector2d{200, 0};
  if (fromOwnGoal.norm() < 900) return std::clamp(angleOf(fromOwnGoal), -1.2, 1.2);
  // A ball at the ground line beside the goal cannot be shot in: play it back before the goal.
  if (ball.x() > world.field.xGroundline - 250 && std::abs(ball.y()) > world.field.yGoal)
    return angleOf(Vector2d{world.field.xGroundline - 500, 0} - ball);
  // The goalie guards the middle and the side on which the ball is: aim at the other side, before
  // the middle at the one to which the robot is turned already.
  const Vector2d middle = world.opponentGoal() - ball;
  const double turned = normalize(world.self.pose.rotation - angleOf(middle));
  const double side =
      std::abs(ball.y()) > 200 ? -std::copysign(1, ball.y()) : std::copysign(1, turned);
  return pastObstacles(
      world,
      angleOf(Vector2d{world.field.xGroundline + 50, side * 0.5 * world.field.yGoal} - ball));
}

}  // namespace

double kickDirection(const WorldState& world) {
  const double wanted = wantedDirection(world);
  const Vector2d ball = world.knownBallOnField();
  // At a wall the robot cannot get behind the ball everywhere: the nearest direction for which it
  // can.
  for (int degrees = 0; degrees <= 180; degrees += 10)
    for (const int side : {1, -1}) {
      const double candidate = normalize(wanted + side * fromDegrees(degrees));
      if (hasRoom(world.field, ball, candidate)) return candidate;
    }
  return wanted;
}

double kickTolerance(const WorldState& world) {
  // The robot turns until the aim is just good enough, so half of what still hits the goal.
  const double distance = std::max((world.opponentGoal() - world.knownBallOnField()).norm(), 1.0);
  return std::clamp(0.4 * std::atan2(world.field.yGoal, distance), fromDegrees(5), fromDegrees(15));
}

}  // namespace gt
