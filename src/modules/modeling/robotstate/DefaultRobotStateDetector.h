#pragma once
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/RobotState.h"
#include "representations/perception/BodyPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Default* of RobotStateDetector: detects falls and being lifted up, and measures for
/// how long switches have been pressed (report, chapter 3's table).
class DefaultRobotStateDetector {
 public:
  struct Parameters {
    std::int64_t settleTime = 200;

    static constexpr auto fields() {
      return Fields{field<&Parameters::settleTime>(
          Unit::ms, "time for which a state must be perceived before it counts", {0, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the body's state and the switches. Without new sensor readings the state does not
  /// change.
  void update(const BodyPercept& body, const FrameInfo& frame, RobotState& state);

 private:
  BodyState believed_ = BodyState::standing, perceived_ = BodyState::standing;
  Time perceivedSince_ = never(), lastChange_ = never();
  EnumArray<Switch, bool> pressed_;
  EnumArray<Switch, Time> pressedSince_;
};

}  // namespace gt
