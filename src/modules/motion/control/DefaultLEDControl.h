#pragma once
#include "representations/behavior/LedRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of LEDControl: lights what the behavior asks for, blinking with the clock.
class DefaultLEDControl {
 public:
  struct Parameters {
    int slowPeriod = 1000, fastPeriod = 250;

    static constexpr auto fields() {
      return Fields{field<&Parameters::slowPeriod>(Unit::ms, "on and off", {16, 10000}),
                    field<&Parameters::fastPeriod>(Unit::ms, "on and off", {16, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the LEDs: those that are requested, blinking by the time of the frame.
  void update(const LedRequest& request, const FrameInfo& frame, LedValue& value);
};

}  // namespace gt
