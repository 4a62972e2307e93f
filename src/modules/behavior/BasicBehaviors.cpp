#include "modules/behavior/BasicBehaviors.h"

#include <algorithm>
#include <cmath>

namespace gt {

void Movement::walk(const Vector2d& speed, double turn) {
  const double maxTurn = fromDegrees(parameters_.maxTurn);
  request_ = {MotionType::walk,
              WalkType::normal,
              {std::clamp(turn, -maxTurn, maxTurn),
               std::clamp(speed.x(), -parameters_.maxSideways, parameters_.maxForward),
               std::clamp(speed.y(), -parameters_.maxSideways, parameters_.maxSideways)},
              SpecialAction::none};
}

void Movement::approach(const Vector2d& offset, double turn, double maxSpeed) {
  // Braking: the last 150 mm are walked ever slower, but never so slowly that the robot does not
  // arrive.
  const double distance = offset.norm();
  const double speed = std::min(maxSpeed, 40 + 1.2 * distance);
  Vector2d v = distance < 1 ? Vector2d::Zero() : Vector2d{offset / distance * speed};
  // The same direction at the speed that the slower of the two axes allows.
  const double maxX = v.x() > 0 ? parameters_.maxForward : parameters_.maxSideways;
  const double over = std::max(std::abs(v.x()) / maxX, std::abs(v.y()) / parameters_.maxSideways);
  if (over > 1) v /= over;
  walk(v, 1.5 * turn);
}

Vector2d Movement::avoidMates(const Vector2d& offset) const {
  // A potential field (report 3.8.3): the goal pulls, each team mate nearby pushes away and to the
  // side on which it is passed, so that the robot does not get stuck right before it.
  constexpr double clearance = 500;
  const double distance = std::max(offset.norm(), 1.0);
  Vector2d heading = offset / distance;
  world_.forEachMate([&](const TeamMessage& mate) {
    const Vector2d toMate = relative(world_.self.pose, mate.robotPose.translation);
    const double away = std::max(toMate.norm(), 1.0);
    if (away > clearance || toMate.dot(offset) < 0) return;
    const double side = offset.x() * toMate.y() - offset.y() * toMate.x() > 0 ? -1 : 1;
    const Vector2d past = rotated(toMate / away, side * pi / 2);
    heading += (past - toMate / away) * (clearance / away - 1);
  });
  return heading.normalized() * distance;
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
  movement_.approach(isFar ? movement_.avoidMates(offset) : offset, turn, speed);
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
  if (distance > 600) return movement_.approach(next, angleOf(next), maxSpeed);
  movement_.approach(next, distance > 350 ? angleOf(ball) : 0.5 * normalize(facing + angleOf(ball)),
                     maxSpeed);
}

}  // namespace gt
