#pragma once
#include <cstdint>
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// Makes an image what it would be in the light for which a color table was made, without the
/// color cast of the camera's corners: so that one table is right anywhere in the image, in any
/// light. Both are learned from the carpet, image by image. Light moves all colors along the lines
/// from black to them; the cast grows with the square of the distance from the image's middle
/// and does not depend on the light (measured in images of an ERS-7).
class ImageCorrection {
 public:
  /// The image as it is where there is nothing to correct; else a copy that the next call
  /// overwrites.
  const Image& correct(const Image& image, const Horizon& horizon, const ColorTable64& colors);

  /// By how much the last image became brighter.
  double gain() const { return gain_; }
  /// The cast of cb and cr in the image's corners.
  const Vector2d& cast() const { return cast_; }

 private:
  void allocate(const CameraInfo& info);
  void observe(const Image& image, const Horizon& horizon);
  void solve();
  double gainFor(const ColorTable64& colors) const;
  void apply(const Image& image);

  double gain_ = 1;
  Vector2d cast_ = Vector2d::Zero();
  /// The carpet: its brightness in the image's middle, and its chroma over its brightness.
  double greenY_ = 0;
  Vector2d tone_ = Vector2d::Zero();
  /// Sums over pixels of the carpet, the older the less: of brightness y, distance from the middle
  /// d (squared, 1 in the corners), and chroma.
  double yy_ = 0, yd_ = 0, dd_ = 0;
  Vector2d yChroma_ = Vector2d::Zero(), dChroma_ = Vector2d::Zero();
  Image corrected_;
  std::vector<std::int16_t> columns_, corners_, gains_, neutral_;  ///< For each byte of a row.
};

}  // namespace gt
