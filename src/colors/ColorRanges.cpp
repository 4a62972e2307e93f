#include "colors/ColorRanges.h"

namespace gt {

ColorRange withValue(const ColorRange& range, int value, int size) {
  if (inCircularRange(range, value)) return range;
  const auto forward = [=](int from, int to) { return ((to - from) % size + size) % size; };
  if (forward(range[1], value) <= forward(value, range[0])) return {range[0], value};
  return {value, range[1]};
}

Result<void> checkRanges(const std::string& file, ColorClass colorClass,
                         std::span<const NamedRange> ranges) {
  const std::string name{enumName(colorClass)};
  if (colorClass == ColorClass::noColor)
    return Error{
        .file = file, .field = name, .what = "has no ranges: it is what lies in no other class"};
  for (const NamedRange& r : ranges) {
    if (r.circular || r.range[0] <= r.range[1]) continue;
    const bool missing = r.range == nothing(r.highest);
    return Error{.file = file,
                 .field = name + "." + r.name,
                 .what = missing ? "this class has no such range"
                                 : "the minimum " + std::to_string(r.range[0]) +
                                       " is above the maximum " + std::to_string(r.range[1])};
  }
  return {};
}

std::string sectionOf(ColorClass colorClass, std::span<const NamedRange> ranges) {
  std::string text = "\n[" + std::string{enumName(colorClass)} + "]\n";
  for (const NamedRange& r : ranges)
    text += std::string{r.name} + ' ' + std::to_string(r.range[0]) + ' ' +
            std::to_string(r.range[1]) + '\n';
  return text;
}

}  // namespace gt
