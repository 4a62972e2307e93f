#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/RobotFootprint.h"
#include "representations/modeling/BallModel.h"

namespace gt {

/// Returns whether a ball that rolls a short distance between two positions (mm, relative to the
/// robot) is stopped by the robot's own body. It bounces off the body or lies next to it, unseen
/// below the head, but does not roll through it.
inline bool meetsBody(const Vector2d& from, const Vector2d& to) {
  constexpr double ballRadius = 43;
  const double distance = RobotFootprint::distanceTo(to);
  return distance < ballRadius && distance < RobotFootprint::distanceTo(from);
}

/// A ball locator's estimate of the ball, and when the ball was seen.
struct BallEstimate {
  Vector2d position = Vector2d::Zero();  ///< mm, relative to the robot.
  Vector2d speed = Vector2d::Zero();     ///< mm/s over ground, in the robot's axes.
  Time lastSeen = never(), seenSince = never();

  /// Transforms the estimate after a step of the robot (mm, rad; relative to the robot before).
  void move(const Pose2D& step) {
    position = relative(step, position);
    speed = rotated(speed, -step.rotation);
  }
  /// Moves the ball by its speed for a time (s).
  void roll(double seconds) {
    const Vector2d to = position + speed * seconds;
    if (meetsBody(position, to))
      speed = Vector2d::Zero();
    else
      position = to;
  }
  /// Converts the estimate to a model. Gaps longer than `longestGap` (ms) end the consecutive time
  /// seen.
  BallModel model(Time now, std::int64_t longestGap) const {
    BallModel model;
    model.position = position;
    model.speed = speed;
    model.lastSeen = lastSeen;
    model.consecutiveTimeSeen = now - lastSeen > longestGap ? 0 : lastSeen - seenSince;
    return model;
  }
};

}  // namespace gt
