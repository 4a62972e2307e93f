#include "modules/behavior/skills/BasicBehaviors.h"

#include <algorithm>
#include <cmath>

namespace gt {

void Movement::walk(const Vector2d& speed, double turn) {
  const double maxTurn = fromDegrees(parameters_.maxTurn);
  request(MotionType::walk);
  request_.walk = {std::clamp(turn, -maxTurn, maxTurn),
                   std::clamp(speed.x(), -parameters_.maxSideways, parameters_.maxForward),
                   std::clamp(speed.y(), -parameters_.maxSideways, parameters_.maxSideways)};
}

void Movement::approach(const Vector2d& offset, double turn, double maxSpeed) {
  // Braking: the last 150 mm are walked ever slower, but never so slowly that the robot does not
  // arrive.
  const double distance = offset.norm();
  const double speed = std::min(maxSpeed, 40 + 1.2 * distance);
  Vector2d v = distance < 1 ? Vector2d::Zero() : Vector2d{offset / distance * speed};
  v = keptFromPlayers(v);
  // The same direction at the speed that the slower of the two axes allows.
  const double maxX = v.x() > 0 ? parameters_.maxForward : parameters_.maxSideways;
  const double over = std::max(std::abs(v.x()) / maxX, std::abs(v.y()) / parameters_.maxSideways);
  if (over > 1) v /= over;
  walk(v, 1.5 * turn);
}

Vector2d Movement::keptFromPlayers(Vector2d speed) const {
  // Walking into a robot moves it as little as oneself, and is a foul: what remains of the speed is
  // what leads past it.
  const PlayersCollection& players = world_.players;
  for (const auto* team : {&players.opponents, &players.ownTeam})
    for (const LocatedPlayer& player : *team) {
      const Vector2d to = relative(world_.self.pose, player.position);
      const double distance = to.norm(), room = distance - parameters_.keepOff;
      if (room > 150 || distance < 1) continue;
      const double closing = to.dot(speed) / distance;
      speed -= std::max(0., closing - std::max(0., room)) * to / distance;
    }
  return speed;
}

void Movement::approachAvoiding(const Vector2d& offset, double turn, double maxSpeed) {
  const ObstaclesModel& obstacles = world_.obstacles;
  const double width = parameters_.clearance;
  const double heading = angleOf(offset), needed = std::min(offset.norm(), parameters_.freeWay);
  // Move freely.
  if (obstacles.corridor(heading, width) >= needed) return approach(offset, turn, maxSpeed);
  // Avoid the obstacle: turn to where there is a way, and walk as fast as there is room.
  auto way = obstacles.freeDirection(heading, width, needed);
  if (!way) way = obstacles.freeDirection(heading, width, needed / 2);
  const double room = obstacles.corridor(0, width) - parameters_.stopBefore;
  const double speed = std::clamp(room, -50., maxSpeed);
  walk({way ? speed * std::max(0., std::cos(*way)) : std::min(speed, 0.), 0},
       1.5 * way.value_or(heading));
}

void GoToPoint::execute() {
  const Pose2D& pose = movement_.world().self.pose;
  const Vector2d offset = relative(pose, {x, y});
  const double distance = offset.norm();
  const double finalTurn = normalize(fromDegrees(angle) - pose.rotation);
  arrived_ = distance < (arrived_ ? 60 : 25) && std::abs(finalTurn) < fromDegrees(arrived_ ? 8 : 4);
  if (arrived_) return movement_.stand();
  const bool isFar = distance > 400;
  const double turn = isFar ? angleOf(offset) : finalTurn;
  // Without a speed, as from a person who does not care (report I.5.3: xbb), as fast as it can.
  const double limit = maxSpeed > 0 ? maxSpeed : movement_.parameters().maxForward;
  // Far away the robot walks where it looks, so it turns first.
  const double speed =
      isFar ? limit * std::max(0.2, std::cos(std::min(std::abs(turn), pi / 2))) : limit;
  if (isFar) return movement_.approachAvoiding(offset, turn, speed);
  movement_.approach(offset, turn, speed);
}

void GoToBall::execute() {
  const Vector2d ball = movement_.world().knownBall();
  const double distance = ball.norm();
  const double facing = normalize(fromDegrees(direction) - movement_.world().self.pose.rotation);
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
