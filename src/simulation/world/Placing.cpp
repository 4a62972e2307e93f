// Placement of robots and balls in the world by hand.
#include <algorithm>

#include "representations/infrastructure/RobotDimensions.h"
#include "simulation/world/FreePlace.h"
#include "simulation/world/World.h"

namespace gt {

void World::placeRobot(std::size_t robot, const Pose2D& pose) {
  robots_[robot].pose.rotation = pose.rotation;
  robots_[robot].posture = Posture::standing;
  put({.index = robot, .asked = pose.translation});
}

void World::placeBall(std::size_t ball, const Vector2d& position, const Vector2d& speed,
                      bool forget) {
  const double asked = speed.norm();
  balls_[ball].speed = asked > fastestBall_ ? Vector2d{fastestBall_ / asked * speed} : speed;
  if (forget) balls_[ball].lastToucher = -1;
  put({.ball = true, .index = ball, .asked = position, .askedSpeed = asked});
}

void World::throwOver(std::size_t robot, Posture posture) {
  robots_[robot].posture = posture;
  put({.index = robot, .asked = robots_[robot].pose.translation});
}

void World::standUp(std::size_t robot) {
  throwOver(robot, Posture::standing);
}

void World::turnJoint(std::size_t robot, Joint joint, double angle) {
  const JointLimits limits = limitsOf(joint);
  robots_[robot].joints[joint] = std::clamp(angle, limits.low, limits.high);
  put({.index = robot, .asked = robots_[robot].pose.translation});
}

void World::putAll() {
  for (std::size_t i = 0; i < robots_.size(); ++i)
    put({.index = i, .asked = robots_[i].pose.translation});
  for (std::size_t i = 0; i < balls_.size(); ++i)
    put({.ball = true, .index = i, .asked = balls_[i].position});
}

void World::put(const Put& what) {
  ++putCount_;
  std::erase_if(puts_, [&](const Put& other) {
    return other.ball == what.ball && other.index == what.index;
  });
  puts_.push_back(what);
  for (const Put& waits : puts_) counts(waits) = false;
  for (Put& one : puts_) {
    // A thing that lies at its requested place stays there, unless an earlier one took that place.
    const bool stays = &one != &puts_.back() && one.place == one.asked && isFree(one);
    if (!stays) settle(one);
    counts(one) = true;
  }
}

void World::settle(Put& put) {
  const std::size_t i = put.index;
  if (put.ball) {
    placedBalls_[i] = true;
    put.place = nearestFree(put.asked, [&](const Vector2d& place) {
      moveBall(i, place);
      return ballIsFree(i);
    });
    return moveBall(i, put.place);
  }
  placed_[i] = true;
  Vector2d& center = robots_[i].pose.translation;
  center = put.asked;
  putDown(i);
  put.place = nearestFree(put.asked, [&](const Vector2d& place) {
    const Vector2d way = (place - center) / 1000;
    center = place;
    for (int geom = parts_[i].firstGeom; geom < parts_[i].lastGeom; ++geom)
      for (int k = 0; k < 2; ++k) data_->geom_xpos[3 * geom + k] += way[k];
    return robotIsFree(i);
  });
  if (put.place != put.asked) {
    center = put.place;
    putDown(i);
  }
  cameras_[i].fill(sitePose(*data_, parts_[i].cameraSite));
}

void World::moveBall(std::size_t ball, const Vector2d& place) {
  balls_[ball].position = place;
  writeBall(ball);
}

bool World::isFree(const Put& put) const {
  return put.ball ? ballIsFree(put.index) : robotIsFree(put.index);
}

bool World::robotIsFree(std::size_t robot) const {
  const Vector2d& place = robots_[robot].pose.translation;
  const double reach = parts_[robot].reach;
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (i != robot && robotCounts_[i] &&
        (robots_[i].pose.translation - place).norm() < reach + parts_[i].reach &&
        robotsOverlap(robot, i))
      return false;
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (ballCounts_[i] && (balls_[i].position - place).norm() < reach + ballParts_[i].radius &&
        ballOverlapsRobot(i, robot))
      return false;
  return !robotOverlapsField(robot);
}

bool World::ballIsFree(std::size_t ball) const {
  const Vector2d& place = balls_[ball].position;
  const double radius = ballParts_[ball].radius;
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (robotCounts_[i] &&
        (robots_[i].pose.translation - place).norm() < radius + parts_[i].reach &&
        ballOverlapsRobot(ball, i))
      return false;
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (i != ball && ballCounts_[i] &&
        (balls_[i].position - place).norm() < radius + ballParts_[i].radius - touching)
      return false;
  return !ballOverlapsField(ball);
}

bool World::wouldTouch(std::size_t ball, const Vector2d& place, std::size_t robot) {
  mjtNum* center = data_->geom_xpos + 3 * ballParts_[ball].geom;
  const Vector3d before = Eigen::Map<const Vector3d>{center};
  Eigen::Map<Vector3d>{center} = Vector3d{place.x(), place.y(), ballParts_[ball].radius} / 1000;
  const bool touches = ballOverlapsRobot(ball, robot);
  Eigen::Map<Vector3d>{center} = before;
  return touches;
}

}  // namespace gt
