#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/BodyPercept.h"

namespace gt {

/// The state of the robot's body, and how long its switches have been pressed (report, chapter 3's
/// table). Provided by the RobotStateDetector.
struct RobotState {
  BodyState state = BodyState::standing;
  Time lastChange = never();
  EnumArray<Switch, std::int64_t> pressedFor;
  double tailPan = 0;

  static constexpr auto fields() {
    return Fields{
        field<&RobotState::state>(),
        field<&RobotState::lastChange>(Unit::ms, "when the state changed last"),
        field<&RobotState::pressedFor>(
            Unit::ms, "how long each switch has been pressed; 0 while it is not pressed"),
        field<&RobotState::tailPan>(Unit::rad, "measured pan of the tail, + to the left")};
  }
};

}  // namespace gt
