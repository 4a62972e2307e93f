#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The ball as the robot itself has seen it (report 3.4). Provided by the BallLocator.
struct BallModel {
  Vector2d position = Vector2d::Zero();
  Vector2d speed = Vector2d::Zero();
  Time lastSeen = never();
  std::int64_t consecutiveTimeSeen = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{
        field<&BallModel::position>(Unit::mm, "position on the ground, relative to the robot"),
        field<&BallModel::speed>(Unit::mmPerS, "velocity over ground, in the robot's axes"),
        field<&BallModel::lastSeen>(Unit::ms),
        field<&BallModel::consecutiveTimeSeen>(
            Unit::ms, "how long the ball has been seen without interruption (report 3.4.2)"),
        field<&BallModel::standardDeviation>(
            Unit::mm, "standard deviation of the position; 0 if the locator does not estimate it")};
  }
};

/// The ball as the team knows it: seen by the robot itself or reported by a teammate (report
/// 3.4.2). Provided by the TeamBallLocator.
struct TeamBallModel {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  int seenBy = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{
        field<&TeamBallModel::position>(Unit::mm, "position on the field"),
        field<&TeamBallModel::lastSeen>(Unit::ms,
                                        "when the ball was seen last by the player `seenBy`"),
        field<&TeamBallModel::seenBy>("number of the player whose ball this is; 0: none"),
        field<&TeamBallModel::standardDeviation>(
            Unit::mm, "standard deviation of the position; 0 if the locator does not estimate it")};
  }
};

}  // namespace gt
