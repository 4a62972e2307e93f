#pragma once
#include <optional>

#include "representations/modeling/BallModel.h"

namespace gt {

/// The point and time at which a ball crosses the line through the robot to its left and right (the
/// y axis).
struct Crossing {
  double left = 0;  ///< mm, positive: left of the robot
  double time = 0;  ///< ms, from now
};

/// The crossing of a ball that comes from ahead, rolls straight and loses speed at a constant
/// deceleration (mm/s^2). Empty if it stops before the line, or does not approach.
std::optional<Crossing> crossingOf(const BallModel& ball, double deceleration);

}  // namespace gt
