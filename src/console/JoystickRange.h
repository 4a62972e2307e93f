#pragma once

namespace gt {

/// Speeds and angles that are requested when a joystick's axis is at its end.
constexpr double fastestAhead = 200, fastestSideways = 150;            // mm/s
constexpr double fastestTurn = 1.6;                                    // rad/s
constexpr double widestPan = 1.5, widestTilt = 0.7, widestRoll = 0.5;  // rad

}  // namespace gt
