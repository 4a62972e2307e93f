#pragma once
#include <algorithm>

#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// An RGB color, each component from 0 to 255.
struct Rgb {
  double red = 0, green = 0, blue = 0;
};

/// Converts a color from YCbCr (full range, as in JPEG) to RGB; components are clamped.
inline Rgb rgbOf(double y, double cb, double cr) {
  const auto part = [](double value) { return std::clamp(value, 0.0, 255.0); };
  return {part(y + 1.402 * (cr - 128)), part(y - 0.344136 * (cb - 128) - 0.714136 * (cr - 128)),
          part(y + 1.772 * (cb - 128))};
}
inline Rgb rgbOf(const Pixel& pixel) {
  return rgbOf(pixel.y, pixel.cb, pixel.cr);
}

/// Makes a color table from another classification: each 4x4x4 cube of colors gets the class that
/// `classOf(const Rgb&)` returns for its center.
template <typename ClassOf>
ColorTable64 colorTableBy(ClassOf classOf) {
  ColorTable64 table;
  const auto middle = [](std::size_t cube) { return 4.0 * static_cast<double>(cube) + 1.5; };
  for (std::size_t i = 0; i < table.classes.size(); ++i)
    table.classes[i] = classOf(rgbOf(middle(i >> 12), middle(i >> 6 & 63), middle(i & 63)));
  return table;
}

}  // namespace gt
