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
    return Fields{field<&BallModel::position>(Unit::mm, "on the ground, relative to the robot"),
                  field<&BallModel::speed>(Unit::mmPerS, "over ground, in the robot's axes"),
                  field<&BallModel::lastSeen>(Unit::ms),
                  field<&BallModel::consecutiveTimeSeen>(Unit::ms, "report 3.4.2"),
                  field<&BallModel::standardDeviation>(
                      Unit::mm, "of the position; 0 if the locator does not estimate it")};
  }
};

/// Where the team knows the ball to be: seen by the robot itself or reported by a teammate
/// (report 3.4.2). Provided by the TeamBallLocator.
struct TeamBallModel {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  int seenBy = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{field<&TeamBallModel::position>(Unit::mm, "on the field"),
                  field<&TeamBallModel::lastSeen>(Unit::ms, "by the robot whose ball it is"),
                  field<&TeamBallModel::seenBy>("number of that player, 0 nobody"),
                  field<&TeamBallModel::standardDeviation>(
                      Unit::mm, "of the position; 0 if the locator does not estimate it")};
  }
};

}  // namespace gt
