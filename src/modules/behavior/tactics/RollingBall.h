#pragma once
#include <optional>

#include "representations/modeling/BallModel.h"

namespace gt {

/// Where and when a ball rolls across the line to the left and right of the robot.
struct Crossing {
  double left = 0;  ///< mm
  double time = 0;  ///< ms, from now
};

/// The crossing of a ball that comes from ahead, rolls straight and loses speed at a constant
/// deceleration (mm/s^2). Empty if it stops before, or does not come.
std::optional<Crossing> crossingOf(const BallModel& ball, double deceleration);

}  // namespace gt
