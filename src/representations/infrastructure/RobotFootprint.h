#pragma once
#include <array>

namespace gt {

/// A robot seen from above: two discs on its axis, where it collides with others.
struct RobotFootprint {
  static constexpr double radius = 78;                      ///< mm
  static constexpr std::array<double, 2> middles{62, -55};  ///< mm ahead of the robot's origin.
};

}  // namespace gt
