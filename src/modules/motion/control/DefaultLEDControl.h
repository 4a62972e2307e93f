#pragma once
#include "representations/behavior/LedRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of LEDControl: switches the LEDs that the behavior requests, blinking with
/// the clock.
class DefaultLEDControl {
 public:
  struct Parameters {
    int slowPeriod = 1000, fastPeriod = 250;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::slowPeriod>(Unit::ms, "period of slow blinking", {16, 10000}),
          field<&Parameters::fastPeriod>(Unit::ms, "period of fast blinking", {16, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the states of the LEDs: those requested, blinking by the time of the frame.
  void update(const LedRequest& request, const FrameInfo& frame, LedValue& value);
};

}  // namespace gt
