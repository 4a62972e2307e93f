#pragma once

namespace gt {

/// What a joystick's axis at its end means.
constexpr double fastestAhead = 200, fastestSideways = 150;            // mm/s
constexpr double fastestTurn = 1.6;                                    // rad/s
constexpr double widestPan = 1.5, widestTilt = 0.7, widestRoll = 0.5;  // rad

}  // namespace gt
