#pragma once
#include "base/Enum.h"
#include "streams/Reflection.h"

namespace gt {

/// The LEDs of the ERS-210 (facts, 1.3).
enum class Led {
  lowerLeft,
  middleLeft,
  upperLeft,
  lowerRight,
  middleRight,
  upperRight,
  top,
  tailBlue,
  tailRed
};
/// The two kinds of slow blinking are in opposite phase: LEDs with different kinds alternate.
enum class LedMode { off, on, slowBlink, fastBlink, slowBlinkInTurn };

/// What the LEDs shall show. Provided by BehaviorControl.
struct LedRequest {
  EnumArray<Led, LedMode> modes;

  static constexpr auto fields() {
    return Fields{field<&LedRequest::modes>("mode of each LED, in the order of Led")};
  }
};

/// Which LEDs are lit. Provided by LEDControl.
struct LedValue {
  EnumArray<Led, bool> lit;

  static constexpr auto fields() {
    return Fields{field<&LedValue::lit>("whether each LED is lit, in the order of Led")};
  }
};

}  // namespace gt
