#pragma once
#include <string>
#include <string_view>

#include "colors/ColorRanges.h"
#include "colors/Rgb.h"
#include "streams/Reflection.h"

namespace gt {

/// A color as hue, saturation and intensity (report J.6.2).
struct Hsi {
  int hue = 0;                        ///< Degrees, 0 to 359: red 0, green 120, blue 240; grays 0.
  int saturation = 0, intensity = 0;  ///< Percent.
};
Hsi hsiOf(const Rgb& color);
inline Hsi hsiOf(const Pixel& pixel) {
  return hsiOf(rgbOf(pixel));
}

/// A sector of the HSI space (report J.6.2). Empty by default.
struct HsiRange {
  ColorRange hue{0, 360};  ///< Circular: 350 to 15 are the reds.
  ColorRange saturation = nothing(100), intensity = nothing(100);

  bool empty() const { return saturation[0] > saturation[1] || intensity[0] > intensity[1]; }
  bool contains(const Hsi& color) const {
    return inRange(saturation, color.saturation) && inRange(intensity, color.intensity) &&
           (inCircularRange(hue, color.hue) || (color.hue == 0 && inCircularRange(hue, 360)));
  }
  /// Enlarges the range to include a color. Hue is extended in the direction of the shorter way.
  void include(const Hsi& color);
  /// Reduces the range to exclude a color, at that limit which removes the smallest part of the
  /// range.
  void exclude(const Hsi& color);
  friend bool operator==(const HsiRange&, const HsiRange&) = default;

  static constexpr auto fields() {
    return Fields{field<&HsiRange::hue>(Unit::deg, "minimum and maximum, on a circle", {0, 360}),
                  field<&HsiRange::saturation>(Unit::percent, "minimum and maximum", {0, 100}),
                  field<&HsiRange::intensity>(Unit::percent, "minimum and maximum", {0, 100})};
  }
};

/// Color classes as sectors of the HSI space (report J.6.2). Where sectors overlap, the first one
/// in the list of classes is used.
struct HsiColors {
  EnumArray<ColorClass, HsiRange> ranges;

  ColorClass classOf(const Hsi& color) const;
  ColorClass operator[](const Pixel& pixel) const { return classOf(hsiOf(pixel)); }
  /// Converts the classes to a table of YCbCr.
  ColorTable64 table() const;
  friend bool operator==(const HsiColors& a, const HsiColors& b) {
    return a.ranges.values == b.ranges.values;
  }
  static constexpr auto fields() { return Fields{field<&HsiColors::ranges>()}; }
};

/// Parses a `.hsi` file: for each class a section [CLASS] with lines `hue MIN MAX`, `saturation MIN
/// MAX`, `intensity MIN MAX`. Classes that are not mentioned have no colors.
Result<HsiColors> parseHsiColors(std::string_view text, const std::string& file);
Result<HsiColors> readHsiColors(const std::string& file);
std::string hsiText(const HsiColors& colors);

}  // namespace gt
