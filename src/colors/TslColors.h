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
/// Segmentation and Detection of Human Faces", 1999), each as a byte. Tint and saturation are made
/// from each primary's share of the light, so more or less light changes luminance only.
struct Tsl {
  int tint = 0;  ///< On a circle of 256: green at 45, yellow 96, red 147, blue 224; of grays 0.
  int saturation = 0, luminance = 0;
};
Tsl tslOf(const Rgb& color);
inline Tsl tslOf(const Pixel& pixel) {
  return tslOf(rgbOf(pixel));
}

/// The six thresholds of a color class (report J.6.3). By default nothing lies between them.
struct TslThresholds {
  int priority = 0;
  ColorRange tint{0, 255};  ///< On a circle.
  ColorRange saturation = nothing(255), luminance = nothing(255);

  bool empty() const { return saturation[0] > saturation[1] || luminance[0] > luminance[1]; }
  bool contains(const Tsl& color) const {
    return inRange(luminance, color.luminance) && inRange(saturation, color.saturation) &&
           inCircularRange(tint, color.tint);
  }
  friend bool operator==(const TslThresholds&, const TslThresholds&) = default;

  static constexpr auto fields() {
    return Fields{field<&TslThresholds::priority>(
                      "where classes overlap, the one with the smallest number counts", {0, 1000}),
                  field<&TslThresholds::tint>("minimum and maximum, on a circle", {0, 255}),
                  field<&TslThresholds::saturation>("minimum and maximum", {0, 255}),
                  field<&TslThresholds::luminance>("minimum and maximum", {0, 255})};
  }
};

/// Color classes by thresholds in the TSL space (report J.6.3), from coltable.tsl. Of classes with
/// the same priority the one counts that stands first in the list of classes. Configuration.
struct TslColors {
  EnumArray<ColorClass, TslThresholds> classes;

  ColorClass classOf(const Tsl& color) const;
  ColorClass operator[](const Pixel& pixel) const { return classOf(tslOf(pixel)); }
  /// The same classes as a table of YCbCr.
  ColorTable64 table() const;

  /// The classes that are defined, the one that counts first at the front (the *TSL Order*).
  std::vector<ColorClass> order() const;
  /// Moves a class up or down by one in the order; at its end, or if it is not defined, nothing
  /// happens.
  void moveUp(ColorClass colorClass) { move(colorClass, -1); }
  void moveDown(ColorClass colorClass) { move(colorClass, 1); }

  friend bool operator==(const TslColors& a, const TslColors& b) {
    return a.classes.values == b.classes.values;
  }
  static constexpr auto fields() { return Fields{field<&TslColors::classes>()}; }

 private:
  void move(ColorClass colorClass, int places);
};

/// Reads the text of a `.tsl` file: for each class a section [CLASS] with lines `priority N`, `tint
/// MIN MAX`, `saturation MIN MAX`, `luminance MIN MAX`. Classes that are not mentioned have no
/// colors.
Result<TslColors> parseTslColors(std::string_view text, const std::string& file);
Result<TslColors> readTslColors(const std::string& file);
std::string tslText(const TslColors& colors);

}  // namespace gt
