#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/perception/BodyPercept.h"

namespace gt {

/// What has happened to the robot's body, and how long switches have been pressed (report, chapter
/// 3's table). Provided by the RobotStateDetector.
struct RobotState {
  BodyState state = BodyState::standing;
  Time lastChange = never();
  EnumArray<Switch, std::int64_t> pressedFor;
  double tailPan = 0;

  static constexpr auto fields() {
    return Fields{field<&RobotState::state>(),
                  field<&RobotState::lastChange>(Unit::ms, "of the state"),
                  field<&RobotState::pressedFor>(Unit::ms, "0 while not pressed"),
                  field<&RobotState::tailPan>(Unit::rad, "as measured, + to the left")};
  }
};

}  // namespace gt
