#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/RobotFootprint.h"
#include "representations/modeling/BallModel.h"

namespace gt {

/// Whether a ball that rolls on a short way (mm, relative to the robot) is stopped by the robot's
/// own body: it bounces off or lies at it, unseen below the head, but does not roll through.
inline bool meetsBody(const Vector2d& from, const Vector2d& to) {
  constexpr double ballRadius = 43;
  const double distance = RobotFootprint::distanceTo(to);
  return distance < ballRadius && distance < RobotFootprint::distanceTo(from);
}

/// Where a ball locator believes the ball to be, and when it was seen.
struct BallEstimate {
  Vector2d position = Vector2d::Zero();  ///< mm, relative to the robot.
  Vector2d speed = Vector2d::Zero();     ///< mm/s over ground, in the robot's axes.
  Time lastSeen = never(), seenSince = never();

  /// Moves it with the robot.
  void move(const Pose2D& step) {
    position = relative(step, position);
    speed = rotated(speed, -step.rotation);
  }
  /// Moves it by its speed, for so many seconds.
  void roll(double seconds) {
    const Vector2d to = position + speed * seconds;
    if (meetsBody(position, to))
      speed = Vector2d::Zero();
    else
      position = to;
  }
  /// The model of it. Gaps longer than `longestGap` (ms) end the consecutive time seen.
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
