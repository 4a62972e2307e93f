#include "modules/motion/control/DefaultLEDControl.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(DefaultLEDControl, LightsAndBlinks) {
  DefaultLEDControl control;
  LedRequest request;
  request.modes[Led::top] = LedMode::on;
  request.modes[Led::upperLeft] = LedMode::slowBlink;
  request.modes[Led::upperRight] = LedMode::slowBlinkInTurn;
  request.modes[Led::tailBlue] = LedMode::slowBlink;
  request.modes[Led::tailRed] = LedMode::fastBlink;
  LedValue value;
  EnumArray<Led, int> changes, lit;
  LedValue before;
  for (std::int64_t ms = 0; ms < 4000; ms += 8) {
    control.update(request, {{ms}}, value);
    EXPECT_NE(value.lit[Led::upperLeft], value.lit[Led::upperRight]) << "they alternate";
    for (std::size_t i = 0; i < value.lit.size(); ++i) {
      changes.values[i] += value.lit.values[i] != before.lit.values[i] ? 1 : 0;
      lit.values[i] += value.lit.values[i] ? 1 : 0;
    }
    before = value;
  }
  EXPECT_EQ(lit[Led::top], 500);
  EXPECT_EQ(lit[Led::lowerLeft], 0);
  EXPECT_NEAR(lit[Led::tailBlue], 250, 10);
  EXPECT_EQ(changes[Led::tailBlue], 8);
  EXPECT_EQ(changes[Led::tailRed], 32);
}

}  // namespace
}  // namespace gt
