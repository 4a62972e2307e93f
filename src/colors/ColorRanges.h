#pragma once
#include <array>
#include <span>
#include <string>

#include "base/Result.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// The values of a color class in one channel, from a minimum to a maximum, both included.
using ColorRange = std::array<int, 2>;

/// A range of a channel that contains no values, for classes that are not defined.
constexpr ColorRange nothing(int highest) {
  return {highest, 0};
}

constexpr bool inRange(const ColorRange& range, int value) {
  return range[0] <= value && value <= range[1];
}

/// Whether a range of a circular channel contains a value. A range that leads across zero has a
/// minimum above its maximum.
constexpr bool inCircularRange(const ColorRange& range, int value) {
  return range[0] <= range[1] ? inRange(range, value) : value >= range[0] || value <= range[1];
}

/// The shortest range in a circular channel of `size` values that contains a range and a value.
ColorRange withValue(const ColorRange& range, int value, int size);

/// The number of values in a range of a circular channel of `size` values.
constexpr int circularWidth(const ColorRange& range, int size) {
  return ((range[1] - range[0]) % size + size) % size + 1;
}

/// A named range of a file, for checks and for writing.
struct NamedRange {
  const char* name;
  ColorRange range;
  int highest;  ///< Highest value of the channel.
  bool circular = false;
};

/// Checks the ranges of a class from a file: all must exist, and no minimum may be above its
/// maximum, except in a circular channel. The error's field is CLASS.CHANNEL.
Result<void> checkRanges(const std::string& file, ColorClass colorClass,
                         std::span<const NamedRange> ranges);

/// Formats the ranges of a class as a section of a file.
std::string sectionOf(ColorClass colorClass, std::span<const NamedRange> ranges);

}  // namespace gt
