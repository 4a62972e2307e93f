#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// A rectangle of an image, from its upper left to its lower right pixel, both included.
struct ImageRegion {
  int left = 0, top = 0, right = 0, bottom = 0;

  /// Calls visit(pixel) for all pixels of an image inside the rectangle.
  template <typename Visit>
  void forEachPixel(const Image& image, Visit visit) const {
    for (int y = std::max(top, 0); y <= std::min(bottom, image.info.height - 1); ++y)
      for (int x = std::max(left, 0); x <= std::min(right, image.info.width - 1); ++x)
        visit(image.at(x, y));
  }
};

/// A label by a person: a rectangle of an image that shows one color class.
struct LabeledRegion {
  std::string picture;  ///< Name of a file, or number of a log's image, from 0.
  ColorClass colorClass = ColorClass::noColor;
  ImageRegion region;
};

/// An image with known classes: those of all pixels, as provided by the simulator, or those of
/// regions, as labeled by a person.
struct LabeledImage {
  const Image& image;
  std::span<const ColorClass> classes;  ///< Of all pixels, or empty.
  std::span<const LabeledRegion> regions;

  /// Calls visit(pixel, class) for all pixels whose class is certain. Pixels are excluded if
  /// one of their four neighbors has another class, because blur mixes the colors.
  template <typename Visit>
  void forEachPixel(Visit visit) const {
    for (const LabeledRegion& label : regions)
      label.region.forEachPixel(image, [&](const Pixel& pixel) { visit(pixel, label.colorClass); });
    if (classes.empty()) return;
    const int width = image.info.width, height = image.info.height;
    const auto at = [&](int x, int y) { return classes[static_cast<std::size_t>(y * width + x)]; };
    for (int y = 1; y < height - 1; ++y)
      for (int x = 1; x < width - 1; ++x) {
        const ColorClass c = at(x, y);
        if (at(x - 1, y) == c && at(x + 1, y) == c && at(x, y - 1) == c && at(x, y + 1) == c)
          visit(image.at(x, y), c);
      }
  }
};

/// Parses a table of labels with the columns image, class, left, top, right, bottom.
Result<std::vector<LabeledRegion>> parseRegions(std::string_view text, const std::string& file);
Result<std::vector<LabeledRegion>> readRegions(const std::string& file);

}  // namespace gt
