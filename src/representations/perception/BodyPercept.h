#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

enum class BodyState { standing, fallen, liftedUp };

/// The posture of the body and the state of its switches (report 3.1). Provided by the
/// SensorDataProcessor.
struct BodyPercept {
  Time time;
  BodyState state = BodyState::standing;
  double tilt = 0;
  double roll = 0;
  double height = 0;
  double tailPan = 0;
  EnumArray<Switch, bool> switches;

  static constexpr auto fields() {
    return Fields{
        field<&BodyPercept::time>(Unit::ms),
        field<&BodyPercept::state>(),
        field<&BodyPercept::tilt>(Unit::rad, "tilt of the body, + nose up"),
        field<&BodyPercept::roll>(Unit::rad, "roll of the body, + right side down"),
        field<&BodyPercept::height>(Unit::mm, "height of the body's origin above the ground"),
        field<&BodyPercept::tailPan>(Unit::rad, "measured pan of the tail, + to the left"),
        field<&BodyPercept::switches>("whether each switch is pressed")};
  }
};

}  // namespace gt
