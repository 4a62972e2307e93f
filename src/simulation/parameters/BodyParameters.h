#pragma once
#include "streams/Reflection.h"

namespace gt {

/// Errors of assembly, which differ from robot to robot, and compliance of joints and legs.
/// Differences from robot to robot are normally distributed. Element `body`.
struct BodyParameters {
  double tilt = 0;
  double roll = 0;
  double jointOffset = 0;
  double accelerationOffset = 0;
  double cameraLight = 0;
  double cameraColor = 0;
  double backlash = 0;
  double commandDelay = 0;
  double swayTilt = 0;
  double swayRoll = 0;
  double swayHeight = 0;

  /// Upper bound of `commandDelay` (ms).
  static constexpr double longestDelay = 120;

  static constexpr auto fields() {
    using P = BodyParameters;
    constexpr Range degrees{0, 20};
    return Fields{
        field<&P::tilt>(
            Unit::deg,
            "standard deviation, from robot to robot, of how much the body leans back more than "
            "joints and robot.cfg state",
            degrees),
        field<&P::roll>(
            Unit::deg,
            "standard deviation, from robot to robot, of how much the body leans to the right more than joints and robot.cfg state",
            degrees),
        field<&P::jointOffset>(
            Unit::deg, "standard deviation of the zero of each robot's each joint", degrees),
        field<&P::accelerationOffset>(
            Unit::mmPerS2, "standard deviation of the zero of each robot's acceleration sensors",
            {0, 5000}),
        field<&P::cameraLight>(
            "standard deviation of how bright each robot's camera sees, as a share", {0, 0.5}),
        field<&P::cameraColor>(
            "standard deviation of what each robot's camera adds to cb and to cr", {0, 60}),
        field<&P::backlash>(Unit::deg, "by which a joint can be turned without its sensor noticing",
                            degrees),
        field<&P::commandDelay>(Unit::ms,
                                "from a command until the motors act on it, beyond the next tick",
                                {0, longestDelay}),
        field<&P::swayTilt>(
            Unit::deg,
            "standard deviation of the body's tilt, by legs that give, at 200 mm/s; kinematic "
            "fidelity only, as the other swaying",
            degrees),
        field<&P::swayRoll>(Unit::deg, "standard deviation of the body's roll, as swayTilt",
                            degrees),
        field<&P::swayHeight>(Unit::mm, "standard deviation of the body's height, as swayTilt",
                              {0, 50})};
  }
};

}  // namespace gt
