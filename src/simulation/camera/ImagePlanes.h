#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "simulation/camera/Lanes.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// One channel of an image. All rows have the same margins on both sides, so that loops may run in
/// whole steps and access neighbors without checking the bounds.
class Plane {
 public:
  /// Pixels that can be read beyond both ends of a row.
  static constexpr int margin = 64;
  /// Rows have room for a width that is a multiple of this.
  static constexpr int step = 32;

  void resize(int width, int height);
  int height() const { return height_; }
  /// The width, rounded up to whole steps.
  std::size_t paddedWidth() const { return paddedWidth_; }
  const std::uint8_t* row(int y) const { return &values_[offset(y)]; }
  std::uint8_t* row(int y) { return &values_[offset(y)]; }
  /// A row, or the outermost one above or below.
  const std::uint8_t* nearestRow(int y) const { return row(std::clamp(y, 0, height_ - 1)); }
  /// Gives the margins of a row the values of its outermost pixels.
  void fillMargins(int y);

 private:
  std::size_t offset(int y) const {
    return static_cast<std::size_t>(y) * (paddedWidth_ + 2 * margin) + margin;
  }

  int width_ = 0, height_ = 0;
  std::size_t paddedWidth_ = 0;
  std::vector<std::uint8_t> values_;
};

constexpr std::size_t channelCount = 3;
/// An image by channels: y, cb and cr.
using ImagePlanes = std::array<Plane, channelCount>;

/// Splits the drawn image into planes; the margins stay as they are.
void takePlanes(const Rasterizer& picture, ImagePlanes& planes);
/// Joins a row of each channel to a row of pixels.
[[gnu::always_inline]] inline void joinRow(
    const std::array<const std::uint8_t*, channelCount>& channels, std::span<Pixel> row) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t step = sizeof(Bytes), stores = sizeof(PackedColor);
  auto* out = reinterpret_cast<std::uint8_t*>(row.data());
  const auto [y, cb, cr] = channels;
  std::size_t i = 0;
  for (; i + step <= row.size(); i += step, out += stores * step) {
    const auto ys = load<Bytes>(y + i), cbs = load<Bytes>(cb + i), crs = load<Bytes>(cr + i);
    const auto first = firstPairs(ys, cbs), last = lastPairs(ys, cbs);
    const auto firstUnused = firstPairs(crs, Bytes{}), lastUnused = lastPairs(crs, Bytes{});
    store(out, firstPairs(Shorts(first), Shorts(firstUnused)));
    store(out + step, lastPairs(Shorts(first), Shorts(firstUnused)));
    store(out + 2 * step, firstPairs(Shorts(last), Shorts(lastUnused)));
    store(out + 3 * step, lastPairs(Shorts(last), Shorts(lastUnused)));
  }
  for (; i < row.size(); ++i, out += stores) {
    const PackedColor color =
        PackedColor{y[i]} | PackedColor{cb[i]} << 8 | PackedColor{cr[i]} << 16;
    std::memcpy(out, &color, sizeof color);
  }
}
/// Joins the planes to an image, which must have their size.
void joinPlanes(const ImagePlanes& planes, Image& image);

}  // namespace gt
