#pragma once
#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// Offsets between the posture of this individual robot and the one computed from its measured
/// joints (robot.cfg, report B.4.5). Configuration.
struct RobotCalibration {
  double bodyTiltOffset = 0;
  double bodyRollOffset = 0;
  double bodyHeightOffset = 0;
  double headRollOffset = 0;

  bool operator==(const RobotCalibration&) const = default;

  static constexpr auto fields() {
    return Fields{field<&RobotCalibration::bodyTiltOffset>(
                      Unit::rad, "added to the body's tilt, + nose up", {-0.5, 0.5}),
                  field<&RobotCalibration::bodyRollOffset>(
                      Unit::rad, "added to the body's roll, + right side down", {-0.5, 0.5}),
                  field<&RobotCalibration::bodyHeightOffset>(Unit::mm, "added to the body's height",
                                                             {-50, 50}),
                  field<&RobotCalibration::headRollOffset>(
                      Unit::rad, "added to the head's roll, + right ear down", {-0.5, 0.5})};
  }
};

}  // namespace gt
