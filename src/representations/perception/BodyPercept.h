#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

enum class BodyState { standing, fallen, liftedUp };

/// How the body stands and which switches are pressed (report 3.1). Provided by the
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
    return Fields{field<&BodyPercept::time>(Unit::ms),
                  field<&BodyPercept::state>(),
                  field<&BodyPercept::tilt>(Unit::rad, "of the body, + nose up"),
                  field<&BodyPercept::roll>(Unit::rad, "+ right side down"),
                  field<&BodyPercept::height>(Unit::mm, "of the body's origin above the ground"),
                  field<&BodyPercept::tailPan>(Unit::rad, "as measured, + to the left"),
                  field<&BodyPercept::switches>("pressed")};
  }
};

}  // namespace gt
