#pragma once
#include <array>
#include <span>
#include <string>

#include "base/Result.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// The values that a color class has in one channel, from a minimum to a maximum, both included.
using ColorRange = std::array<int, 2>;

/// A range of a channel that nothing lies in: that of a class which is not defined.
constexpr ColorRange nothing(int highest) {
  return {highest, 0};
}

constexpr bool inRange(const ColorRange& range, int value) {
  return range[0] <= value && value <= range[1];
}

/// The same on a circle: a range may lead across zero, its minimum is above its maximum then.
constexpr bool inCircularRange(const ColorRange& range, int value) {
  return range[0] <= range[1] ? inRange(range, value) : value >= range[0] || value <= range[1];
}

/// The shortest range on a circle of `size` values that holds a range and a value.
ColorRange withValue(const ColorRange& range, int value, int size);

/// How many values lie in a range on a circle of `size` values.
constexpr int circularWidth(const ColorRange& range, int size) {
  return ((range[1] - range[0]) % size + size) % size + 1;
}

/// A range of a file under its name, for checks and for writing.
struct NamedRange {
  const char* name;
  ColorRange range;
  int highest;  ///< Of the channel's values.
  bool circular = false;
};

/// Whether the ranges of a class from a file make sense: all are there, and no minimum is above its
/// maximum, except on a circle. The error's field is CLASS.CHANNEL.
Result<void> checkRanges(const std::string& file, ColorClass colorClass,
                         std::span<const NamedRange> ranges);

/// The ranges of a class as a section of a file.
std::string sectionOf(ColorClass colorClass, std::span<const NamedRange> ranges);

}  // namespace gt
