#pragma once
#include "representations/infrastructure/RobotCalibration.h"

namespace gt {

/// What a robot has learned of itself in play, from what it sees. Provided by the
/// SensorDataProcessor.
struct LearnedCalibration {
  RobotCalibration robot;
  RobotCalibration deviation;
  double imageDelay = 0;

  static constexpr auto fields() {
    return Fields{
        field("robot", &LearnedCalibration::robot, "",
              "by which it works now, that of robot.cfg included; `save` writes it there"),
        field("deviation", &LearnedCalibration::deviation, "", "its standard deviations"),
        field("imageDelay", &LearnedCalibration::imageDelay, "ms",
              "by which images are older than their time stamps")};
  }
};

}  // namespace gt
