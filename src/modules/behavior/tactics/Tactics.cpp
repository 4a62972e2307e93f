#include "modules/behavior/tactics/Tactics.h"

#include <algorithm>

#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {

void Tactics::update(const WorldState& world) {
  world_ = &world;
  obstacles_ = world.obstacles;
  addTeammatesToObstacles();
  role_ = negotiateRole();
}

void Tactics::addTeammatesToObstacles() {
  const double halfWidth = p_.teammateWidth / 2;
  for (const LocatedPlayer& mate : world_->players.ownTeam) {
    if (mate.number == 0) continue;
    const Vector2d middle = relative(world_->self.pose, mate.position);
    const double distance = std::max(middle.norm(), 1.0);
    const Vector2d away = middle / distance, aside = rotated(away, pi / 2);
    const Vector2d front = middle - away * std::min(halfWidth, distance / 2);
    for (const double part : {-1., -0.5, 0., 0.5, 1.})
      obstacles_.enter(front + part * halfWidth * aside, true, mate.lastSeen);
  }
}

bool Tactics::ownBall() const {
  const WorldState& w = *world_;
  return w.ball.lastSeen >= w.teamBall.lastSeen ||
         static_cast<double>(w.frame.time - w.ball.lastSeen) < p_.ownBall;
}

Vector2d Tactics::knownBall() const {
  const WorldState& w = *world_;
  return ownBall() ? w.ball.position : relative(w.self.pose, w.teamBall.position);
}

Vector2d Tactics::knownBallOnField() const {
  const WorldState& w = *world_;
  return ownBall() ? w.self.pose * w.ball.position : w.teamBall.position;
}

std::int64_t Tactics::knownBallAge() const {
  const WorldState& w = *world_;
  return std::min(w.frame.time - w.ball.lastSeen, w.frame.time - w.teamBall.lastSeen);
}

double Tactics::estimatedTimeToReachBall() const {
  const Vector2d ball = knownBall();
  const Vector2d toGoal = opponentGoal() - knownBallOnField();
  const double wrongSide =
      std::abs(normalize(angleOf(toGoal) - world_->self.pose.rotation - angleOf(ball)));
  return ball.norm() / p_.walkSpeed + std::abs(angleOf(ball)) / p_.turnSpeed +
         wrongSide * p_.wrongSide / p_.walkSpeed +
         p_.unseenBall * static_cast<double>(knownBallAge());
}

DynamicRole Tactics::negotiateRole() const {
  const WorldState& w = *world_;
  if (w.player.role == PlayerRole::goalie) return DynamicRole::goalie;
  const double own =
      estimatedTimeToReachBall() - (role_ == DynamicRole::striker ? p_.strikerAdvantage : 0);
  const double ahead = role_ == DynamicRole::offensiveSupporter ? p_.forwardAdvantage : 0;
  bool nearest = true, mostForward = true;
  for (const TeamMessages::Received& received : w.team.byPlayer) {
    const TeamMessage& mate = received.message;
    const bool heard = static_cast<double>(w.frame.time - received.timeReceived) < p_.heard;
    if (!heard || mate.playerNumber <= 1 || mate.playerNumber == w.player.number()) continue;
    const bool isStriker = mate.behavior.role == DynamicRole::striker;
    const double time =
        mate.behavior.estimatedTimeToReachBall - (isStriker ? p_.strikerAdvantage : 0);
    if (time < own || (time == own && mate.playerNumber < w.player.number())) nearest = false;
    if (!isStriker && mate.robotPose.translation.x() > w.self.pose.translation.x() + ahead)
      mostForward = false;
  }
  if (nearest) return DynamicRole::striker;
  return mostForward ? DynamicRole::offensiveSupporter : DynamicRole::defensiveSupporter;
}

/// Whether a robot that stands behind the ball and faces a direction has room between the walls.
bool Tactics::hasRoom(const Vector2d& ball, double facing) const {
  const FieldDimensions& field = world_->field;
  const double clearance = p_.wallClearance;
  const Vector2d back = ball - direction(facing) * p_.bodyLength;
  const bool insideWalls = std::abs(back.x()) < field.xGroundline - clearance &&
                           std::abs(back.y()) < field.ySideline - clearance;
  const double corner =
      (field.xGroundline - std::abs(back.x())) + (field.ySideline - std::abs(back.y()));
  return insideWalls &&
         corner > field.xGroundline - field.xSideCorner + clearance * p_.cornerClearance;
}

/// The direction nearest to a wanted one in which other robots do not stop the ball at once; before
/// the goal, to the middle of its free part (report 3.8.2).
double Tactics::pastObstacles(double wanted) const {
  const WorldState& w = *world_;
  const Vector2d ball = knownBall();
  if (ball.norm() > p_.handled) return wanted;  // nobody knows what is there
  const double toField = w.self.pose.rotation;
  const Vector2d left = relative(w.self.pose, {w.field.xGroundline, w.field.yGoal});
  const Vector2d right = relative(w.self.pose, {w.field.xGroundline, -w.field.yGoal});
  if (((left + right) / 2 - ball).norm() < p_.shot)
    if (const auto part = freeGoalPart(obstacles_, ball, left, right, p_.ballCorridor)) {
      const double all = normalize(angleOf(left - ball) - angleOf(right - ball));
      if (part->width < p_.openGoal * all) return normalize(part->middle + toField);
    }
  const auto free = freeDirection(obstacles_, normalize(wanted - toField), p_.ballCorridor,
                                  p_.freeAhead, fromDegrees(p_.mostAround), ball);
  return free ? normalize(*free + toField) : wanted;
}

/// Where the ball should go if there were no walls.
double Tactics::wantedDirection() const {
  const WorldState& w = *world_;
  const Vector2d ball = knownBallOnField();
  // Near the own goal: away from it, since a ball played across the goal's mouth is a present for
  // the opponent.
  const Vector2d fromOwnGoal = ball - ownGoal() + Vector2d{p_.ownGoalDepth, 0};
  if (fromOwnGoal.norm() < p_.ownGoalRadius)
    return std::clamp(angleOf(fromOwnGoal), -p_.ownGoalAngle, p_.ownGoalAngle);
  // A ball at the ground line beside the goal cannot be shot in: play it back before the goal.
  if (ball.x() > w.field.xGroundline - p_.besideGoal && std::abs(ball.y()) > w.field.yGoal)
    return angleOf(Vector2d{w.field.xGroundline - p_.beforeGoal, 0} - ball);
  // The goalie guards the middle and the side on which the ball is: aim at the other side, before
  // the middle at the one to which the robot is turned already.
  const Vector2d middle = opponentGoal() - ball;
  const double turned = normalize(w.self.pose.rotation - angleOf(middle));
  const double side =
      std::abs(ball.y()) > p_.middle ? -std::copysign(1, ball.y()) : std::copysign(1, turned);
  return pastObstacles(angleOf(
      Vector2d{w.field.xGroundline + p_.behindGoalLine, side * p_.aside * w.field.yGoal} - ball));
}

double Tactics::kickDirection() const {
  const double wanted = wantedDirection();
  const Vector2d ball = knownBallOnField();
  // At a wall the robot cannot get behind the ball everywhere: the nearest direction for which it
  // can.
  for (int degrees = 0; degrees <= 180; degrees += 10)
    for (const int side : {1, -1}) {
      const double candidate = normalize(wanted + side * fromDegrees(degrees));
      if (hasRoom(ball, candidate)) return candidate;
    }
  return wanted;
}

double Tactics::kickTolerance() const {
  // The robot turns until the aim is just good enough, so less than what still hits the goal.
  const double distance = std::max((opponentGoal() - knownBallOnField()).norm(), 1.0);
  return std::clamp(p_.goalShare * std::atan2(world_->field.yGoal, distance),
                    fromDegrees(p_.leastTolerance), fromDegrees(p_.mostTolerance));
}

}  // namespace gt
