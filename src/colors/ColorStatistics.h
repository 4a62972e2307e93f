#pragma once
#include <cstdint>
#include <vector>

#include "colors/HsiColors.h"
#include "colors/LabeledImage.h"
#include "colors/TslColors.h"

namespace gt {

/// Counts how often each color occurs in each class, in images whose pixels have known classes.
/// Color tables, HSI ranges and TSL thresholds are derived from the counts.
class ColorStatistics {
 public:
  ColorStatistics();

  /// Counts a pixel.
  void add(const Pixel& pixel, ColorClass colorClass) {
    ++counts_[ColorTable64::index(pixel.y, pixel.cb, pixel.cr)][colorClass];
  }
  /// Counts those pixels of an image whose class is certain.
  void add(const LabeledImage& picture) {
    picture.forEachPixel([this](const Pixel& pixel, ColorClass c) { add(pixel, c); });
  }
  void add(const Image& image, std::span<const ColorClass> classes) { add({image, classes, {}}); }

  /// A color table: each color gets the class of most of its pixels, if these are at least 70 % and
  /// at least `leastPixels`. Colors that were never counted get the class of their neighbors if
  /// these agree, repeated in `growth` steps.
  ColorTable64 table(int growth, std::uint32_t leastPixels = 2) const;

  /// The narrowest ranges that contain a share of each class's pixels in each channel. In TSL,
  /// classes have priority by the share of their own pixels among all pixels within their
  /// thresholds. In HSI the order of classes is fixed.
  TslColors tsl(double share) const;
  HsiColors hsi(double share) const;

 private:
  using Counts = EnumArray<ColorClass, std::uint32_t>;

  void grow(ColorTable64& table, std::uint32_t leastPixels) const;
  void setPriorities(TslColors& colors) const;
  /// Calls visit(rgb, counts) for all counted colors, with the center of each color's cube.
  template <typename Visit>
  void forEachColor(Visit visit) const;

  std::vector<Counts> counts_;  ///< For each color of a table.
};

}  // namespace gt
