#pragma once
#include "representations/infrastructure/RobotCalibration.h"

namespace gt {

/// Calibration that the robot has learned during play from its images. Provided by the
/// SensorDataProcessor.
struct LearnedCalibration {
  RobotCalibration robot;
  RobotCalibration deviation;
  double legsGive = 1;
  double imageDelay = 0;

  static constexpr auto fields() {
    return Fields{field<&LearnedCalibration::robot>(
                      "present calibration, including that of robot.cfg; `save` writes it there"),
                  field<&LearnedCalibration::deviation>("standard deviations of what was learned"),
                  field<&LearnedCalibration::legsGive>(
                      "compliance of the legs, as a share of that in the processor's parameters"),
                  field<&LearnedCalibration::imageDelay>(
                      Unit::ms, "by which images are older than their time stamps")};
  }
};

}  // namespace gt
