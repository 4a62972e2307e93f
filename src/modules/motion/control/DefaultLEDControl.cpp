#include "modules/motion/control/DefaultLEDControl.h"

namespace gt {
namespace {

bool onInPeriod(Time now, int period) {
  return now.ms % period < period / 2;
}

}  // namespace

void DefaultLEDControl::update(const LedRequest& request, const FrameInfo& frame, LedValue& value) {
  for (std::size_t i = 0; i < request.modes.size(); ++i) {
    const auto mode = request.modes.values[i];
    value.lit.values[i] =
        mode == LedMode::on ||
        (mode == LedMode::slowBlink && onInPeriod(frame.time, parameters.slowPeriod)) ||
        (mode == LedMode::slowBlinkInTurn && !onInPeriod(frame.time, parameters.slowPeriod)) ||
        (mode == LedMode::fastBlink && onInPeriod(frame.time, parameters.fastPeriod));
  }
}

}  // namespace gt
