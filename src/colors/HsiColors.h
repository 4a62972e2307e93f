#pragma once
#include <string>
#include <string_view>

#include "colors/ColorRanges.h"
#include "colors/Rgb.h"
#include "streams/Reflection.h"

namespace gt {

/// A color as hue, saturation and intensity (report J.6.2).
struct Hsi {
  int hue = 0;  ///< Degrees, 0 to 359: red, green at 120, blue at 240; of grays 0.
  int saturation = 0, intensity = 0;  ///< Percent.
};
Hsi hsiOf(const Rgb& color);
inline Hsi hsiOf(const Pixel& pixel) {
  return hsiOf(rgbOf(pixel));
}

/// A sector of the HSI space (report J.6.2). By default nothing lies in it.
struct HsiRange {
  ColorRange hue{0, 360};  ///< On a circle: from 350 to 15 are the reds.
  ColorRange saturation = nothing(100), intensity = nothing(100);

  bool empty() const { return saturation[0] > saturation[1] || intensity[0] > intensity[1]; }
  bool contains(const Hsi& color) const {
    return inRange(saturation, color.saturation) && inRange(intensity, color.intensity) &&
           (inCircularRange(hue, color.hue) || (color.hue == 0 && inCircularRange(hue, 360)));
  }
  /// Enlarges the range until a color lies in it; hue grows the shorter way round.
  void include(const Hsi& color);
  /// Reduces the range until a color lies outside, by whatever takes the smallest part of it.
  void exclude(const Hsi& color);
  friend bool operator==(const HsiRange&, const HsiRange&) = default;

  static constexpr auto fields() {
    return Fields{field<&HsiRange::hue>(Unit::deg, "minimum and maximum, on a circle", {0, 360}),
                  field<&HsiRange::saturation>(Unit::percent, "minimum and maximum", {0, 100}),
                  field<&HsiRange::intensity>(Unit::percent, "minimum and maximum", {0, 100})};
  }
};

/// Color classes as sectors of the HSI space (report J.6.2). Where sectors overlap the class
/// counts that stands first in the list of classes.
struct HsiColors {
  EnumArray<ColorClass, HsiRange> ranges;

  ColorClass classOf(const Hsi& color) const;
  ColorClass operator[](const Pixel& pixel) const { return classOf(hsiOf(pixel)); }
  /// The same classes as a table of YCbCr.
  ColorTable64 table() const;
  friend bool operator==(const HsiColors& a, const HsiColors& b) {
    return a.ranges.values == b.ranges.values;
  }
  static constexpr auto fields() { return Fields{field<&HsiColors::ranges>()}; }
};

/// Reads the text of a `.hsi` file: for each class a section [CLASS] with lines `hue MIN MAX`,
/// `saturation MIN MAX`, `intensity MIN MAX`. Classes that are not mentioned have no colors.
Result<HsiColors> parseHsiColors(std::string_view text, const std::string& file);
Result<HsiColors> readHsiColors(const std::string& file);
std::string hsiText(const HsiColors& colors);

}  // namespace gt
