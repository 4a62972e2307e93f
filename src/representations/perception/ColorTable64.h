#pragma once
#include <array>
#include <cstdint>

#include "base/Enum.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// The color classes of the report (B.4.2), in the order of its files.
enum class ColorClass : std::uint8_t {
  noColor,
  orange,
  yellow,
  skyblue,
  pink,
  red,
  blue,
  green,
  gray,
  white,
  black
};

/// The color class of each color, with 6 bits per channel (report B.4.2): read from coltable.c64.
/// Configuration.
struct ColorTable64 {
  std::array<ColorClass, 64 * 64 * 64> classes{};

  static constexpr std::size_t index(std::uint8_t y, std::uint8_t cb, std::uint8_t cr) {
    constexpr std::size_t used = 0xfc;
    return (y & used) << 10 | (cb & used) << 4 | cr >> 2;
  }
  ColorClass operator[](const Pixel& p) const { return classes[index(p.y, p.cb, p.cr)]; }

  static constexpr auto fields() {
    return Fields{field<&ColorTable64::classes>("class of each color, index [y][cb][cr]")};
  }
};

}  // namespace gt
