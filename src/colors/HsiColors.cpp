#include "colors/HsiColors.h"

#include <algorithm>
#include <cmath>

#include "base/Geometry.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr int circle = 360;

std::array<NamedRange, 3> named(const HsiRange& range) {
  return {{{"hue", range.hue, 360, true},
           {"saturation", range.saturation, 100},
           {"intensity", range.intensity, 100}}};
}

/// A range cut at one of its ends so that a value lies outside, and what share of it that takes.
struct Cut {
  ColorRange range;
  double share;
};

Cut without(const ColorRange& range, int value) {
  const double width = range[1] - range[0] + 1;
  const int below = value - range[0] + 1, above = range[1] - value + 1;
  if (below <= above) return {{value + 1, range[1]}, below / width};
  return {{range[0], value - 1}, above / width};
}

Cut withoutHue(const ColorRange& range, int hue) {
  const double width = range == ColorRange{0, circle} ? circle : circularWidth(range, circle);
  const int below = ((hue - range[0]) % circle + circle) % circle + 1;
  const int above = ((range[1] - hue) % circle + circle) % circle + 1;
  if (width >= circle || std::min(below, above) >= width) return {{}, 1};  // no end, nothing left
  if (below <= above) return {{(hue + 1) % circle, range[1]}, below / width};
  return {{range[0], (hue + circle - 1) % circle}, above / width};
}

}  // namespace

Hsi hsiOf(const Rgb& color) {
  const auto [r, g, b] = color;
  const double sum = r + g + b, least = std::min({r, g, b});
  const auto rounded = [](double value) { return static_cast<int>(std::lround(value)); };
  Hsi hsi;
  hsi.intensity = rounded(100 * sum / 765);
  hsi.saturation = sum > 0 ? rounded(100 * (1 - 3 * least / sum)) : 0;
  const double turn = std::atan2(std::sqrt(3.0) * (g - b), 2 * r - g - b);
  hsi.hue = (rounded(toDegrees(turn)) + circle) % circle;
  return hsi;
}

void HsiRange::include(const Hsi& color) {
  if (empty()) {
    *this = {{color.hue, color.hue},
             {color.saturation, color.saturation},
             {color.intensity, color.intensity}};
    return;
  }
  const auto enlarge = [](ColorRange& range, int value) {
    range = {std::min(range[0], value), std::max(range[1], value)};
  };
  if (!(color.hue == 0 && inCircularRange(hue, circle))) hue = withValue(hue, color.hue, circle);
  enlarge(saturation, color.saturation);
  enlarge(intensity, color.intensity);
}

void HsiRange::exclude(const Hsi& color) {
  if (!contains(color)) return;
  const Cut byHue = withoutHue(hue, color.hue);
  const Cut bySaturation = without(saturation, color.saturation);
  const Cut byIntensity = without(intensity, color.intensity);
  const double least = std::min({byHue.share, bySaturation.share, byIntensity.share});
  if (least == byHue.share && least < 1)
    hue = byHue.range;
  else if (least == bySaturation.share)
    saturation = bySaturation.range;
  else
    intensity = byIntensity.range;
  if (empty()) *this = {};
}

ColorClass HsiColors::classOf(const Hsi& color) const {
  for (std::size_t i = 0; i < ranges.size(); ++i)
    if (ranges.values[i].contains(color)) return static_cast<ColorClass>(i);
  return ColorClass::noColor;
}

ColorTable64 HsiColors::table() const {
  return colorTableBy([&](const Rgb& color) { return classOf(hsiOf(color)); });
}

Result<HsiColors> parseHsiColors(std::string_view text, const std::string& file) {
  HsiColors colors;
  if (auto done = parseConfig(text, file, colors.ranges); !done) return done.error();
  for (std::size_t i = 0; i < colors.ranges.size(); ++i) {
    const HsiRange& range = colors.ranges.values[i];
    if (range == HsiRange{}) continue;
    if (auto done = checkRanges(file, static_cast<ColorClass>(i), named(range)); !done)
      return done.error();
  }
  return colors;
}

Result<HsiColors> readHsiColors(const std::string& file) {
  const auto text = readFile(file);
  return text ? parseHsiColors(*text, file) : text.error();
}

std::string hsiText(const HsiColors& colors) {
  std::string text = "// hue in degrees on a circle, saturation and intensity in percent\n";
  for (std::size_t i = 0; i < colors.ranges.size(); ++i)
    if (const HsiRange& range = colors.ranges.values[i]; !range.empty())
      text += sectionOf(static_cast<ColorClass>(i), named(range));
  return text;
}

}  // namespace gt
