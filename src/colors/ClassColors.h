#pragma once
#include "base/Enum.h"
#include "debug/Drawing.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// The color in which a color class is displayed.
constexpr Color displayColor(ColorClass colorClass) {
  constexpr EnumArray<ColorClass, Color> shown{
      {Color{128, 128, 128}, colors::orange, colors::yellow, colors::skyblue, colors::pink,
       colors::red, colors::blue, colors::green, Color{170, 170, 170}, colors::white,
       colors::black}};
  return shown[colorClass];
}

}  // namespace gt
