#pragma once
#include "representations/infrastructure/RobotCalibration.h"

namespace gt {

/// What a robot has learned of itself in play, from what it sees. Provided by the
/// SensorDataProcessor.
struct LearnedCalibration {
  RobotCalibration robot;
  RobotCalibration deviation;
  double legsGive = 1;
  double imageDelay = 0;

  static constexpr auto fields() {
    return Fields{field<&LearnedCalibration::robot>(
                      "by which it works now, that of robot.cfg included; `save` writes it there"),
                  field<&LearnedCalibration::deviation>("standard deviations of what was learned"),
                  field<&LearnedCalibration::legsGive>(
                      "how much its legs give, as a share of what the processor's parameters say"),
                  field<&LearnedCalibration::imageDelay>(
                      Unit::ms, "by which images are older than their time stamps")};
  }
};

}  // namespace gt
