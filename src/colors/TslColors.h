#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "colors/ColorRanges.h"
#include "colors/Rgb.h"
#include "streams/Reflection.h"

namespace gt {

/// A color as T', S' and L' (report J.6.3): tint, saturation and luminance of Terrillon and
/// Akamatsu's TSL space ("Comparative Performance of Different Chrominance Spaces for Color
/// Segmentation and Detection of Human Faces", 1999), each as a byte. Tint and saturation depend
/// only on the shares of the primaries, so the amount of light changes luminance only.
struct Tsl {
  int tint = 0;  ///< Circular with 256 values: green 45, yellow 96, red 147, blue 224; grays 0.
  int saturation = 0, luminance = 0;
};
Tsl tslOf(const Rgb& color);
inline Tsl tslOf(const Pixel& pixel) {
  return tslOf(rgbOf(pixel));
}

/// The six thresholds of a color class (report J.6.3). The ranges are empty by default.
struct TslThresholds {
  int priority = 0;
  ColorRange tint{0, 255};  ///< Circular.
  ColorRange saturation = nothing(255), luminance = nothing(255);

  bool empty() const { return saturation[0] > saturation[1] || luminance[0] > luminance[1]; }
  bool contains(const Tsl& color) const {
    return inRange(luminance, color.luminance) && inRange(saturation, color.saturation) &&
           inCircularRange(tint, color.tint);
  }
  friend bool operator==(const TslThresholds&, const TslThresholds&) = default;

  static constexpr auto fields() {
    return Fields{field<&TslThresholds::priority>(
                      "priority where classes overlap; the smallest number is used", {0, 1000}),
                  field<&TslThresholds::tint>("minimum and maximum, on a circle", {0, 255}),
                  field<&TslThresholds::saturation>("minimum and maximum", {0, 255}),
                  field<&TslThresholds::luminance>("minimum and maximum", {0, 255})};
  }
};

/// Color classes by thresholds in the TSL space (report J.6.3), from coltable.tsl. Among classes
/// with the same priority, the first one in the list of classes is used. Configuration.
struct TslColors {
  EnumArray<ColorClass, TslThresholds> classes;

  ColorClass classOf(const Tsl& color) const;
  ColorClass operator[](const Pixel& pixel) const { return classOf(tslOf(pixel)); }
  /// Converts the classes to a table of YCbCr.
  ColorTable64 table() const;

  /// The defined classes, by priority, the highest first (the *TSL Order*).
  std::vector<ColorClass> order() const;
  /// Moves a class up or down by one in the order. Nothing happens at the end of the order, or if
  /// the class is not defined.
  void moveUp(ColorClass colorClass) { move(colorClass, -1); }
  void moveDown(ColorClass colorClass) { move(colorClass, 1); }

  friend bool operator==(const TslColors& a, const TslColors& b) {
    return a.classes.values == b.classes.values;
  }
  static constexpr auto fields() { return Fields{field<&TslColors::classes>()}; }

 private:
  void move(ColorClass colorClass, int places);
};

/// Parses a `.tsl` file: for each class a section [CLASS] with lines `priority N`, `tint MIN MAX`,
/// `saturation MIN MAX`, `luminance MIN MAX`. Classes that are not mentioned have no colors.
Result<TslColors> parseTslColors(std::string_view text, const std::string& file);
Result<TslColors> readTslColors(const std::string& file);
std::string tslText(const TslColors& colors);

}  // namespace gt
