#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/modeling/BallModel.h"

namespace gt {

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
