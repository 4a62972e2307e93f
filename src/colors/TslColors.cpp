#include "colors/TslColors.h"

#include <algorithm>
#include <cmath>

#include "base/Geometry.h"
#include "streams/Config.h"

namespace gt {
namespace {

std::array<NamedRange, 3> named(const TslThresholds& thresholds) {
  return {{{"tint", thresholds.tint, 255, true},
           {"saturation", thresholds.saturation, 255},
           {"luminance", thresholds.luminance, 255}}};
}

}  // namespace

Tsl tslOf(const Rgb& color) {
  const auto [r, g, b] = color;
  const auto rounded = [](double value) { return static_cast<int>(std::lround(value)); };
  Tsl tsl;
  tsl.luminance = std::min(255, rounded(0.299 * r + 0.587 * g + 0.114 * b));
  const double sum = r + g + b;
  if (sum <= 0) return tsl;
  const double red = r / sum - 1.0 / 3, green = g / sum - 1.0 / 3;
  tsl.saturation = std::min(255, rounded(255 * std::sqrt(1.8 * (red * red + green * green))));
  // One turn is 256, so that the largest byte and 0 are neighbors.
  if (tsl.saturation > 0)
    tsl.tint = rounded(256 * (std::atan2(red, green) / (2 * pi) + 0.25)) & 255;
  return tsl;
}

ColorClass TslColors::classOf(const Tsl& color) const {
  ColorClass found = ColorClass::noColor;
  for (std::size_t i = 1; i < classes.size(); ++i)
    if (classes.values[i].contains(color) &&
        (found == ColorClass::noColor || classes.values[i].priority < classes[found].priority))
      found = static_cast<ColorClass>(i);
  return found;
}

ColorTable64 TslColors::table() const {
  return colorTableBy([&](const Rgb& color) { return classOf(tslOf(color)); });
}

std::vector<ColorClass> TslColors::order() const {
  std::vector<ColorClass> order;
  for (std::size_t i = 1; i < classes.size(); ++i)
    if (!classes.values[i].empty()) order.push_back(static_cast<ColorClass>(i));
  std::ranges::stable_sort(order, {}, [&](ColorClass c) { return classes[c].priority; });
  return order;
}

void TslColors::move(ColorClass colorClass, int places) {
  std::vector<ColorClass> list = order();
  const auto from = std::ranges::find(list, colorClass);
  if (from == list.end()) return;
  const auto to = from - list.begin() + places;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(list.size())) return;
  std::swap(*from, list[static_cast<std::size_t>(to)]);
  for (std::size_t i = 0; i < list.size(); ++i) classes[list[i]].priority = static_cast<int>(i + 1);
}

Result<TslColors> parseTslColors(std::string_view text, const std::string& file) {
  TslColors colors;
  if (auto done = parseConfig(text, file, colors.classes); !done) return done.error();
  for (std::size_t i = 0; i < colors.classes.size(); ++i) {
    const TslThresholds& thresholds = colors.classes.values[i];
    if (thresholds == TslThresholds{}) continue;
    if (auto done = checkRanges(file, static_cast<ColorClass>(i), named(thresholds)); !done)
      return done.error();
  }
  return colors;
}

Result<TslColors> readTslColors(const std::string& file) {
  const auto text = readFile(file);
  return text ? parseTslColors(*text, file) : text.error();
}

std::string tslText(const TslColors& colors) {
  std::string text = "// bytes, tint on a circle; of classes that overlap the first one counts\n";
  for (const ColorClass c : colors.order())
    text += sectionOf(c, named(colors.classes[c])) + "priority " +
            std::to_string(colors.classes[c].priority) + '\n';
  return text;
}

}  // namespace gt
