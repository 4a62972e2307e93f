#pragma once
#include <cstdint>
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// Corrects the light and the color cast of an image, so that one color table is right anywhere in
/// the image, in any light. The corrected image has the light for which the color table was made
/// and no color cast in the corners. Both are learned from the carpet, image by image. Light moves
/// all colors along the lines from black; the cast grows with the square of the distance from the
/// image's middle and does not depend on the light (measured in images of an ERS-7).
class ImageCorrection {
 public:
  /// Returns the image itself if no correction is needed; otherwise a corrected copy that the next
  /// call overwrites.
  const Image& correct(const Image& image, const Horizon& horizon, const ColorTable64& colors);

  /// The factor by which the last image was made brighter.
  double gain() const { return gain_; }
  /// The color cast (cb, cr) in the image's corners.
  const Vector2d& cast() const { return cast_; }

 private:
  void allocate(const CameraInfo& info);
  void observe(const Image& image, const Horizon& horizon);
  void solve();
  double gainFor(const ColorTable64& colors) const;
  void apply(const Image& image);

  double gain_ = 1;
  Vector2d cast_ = Vector2d::Zero();
  /// The carpet's brightness in the image's middle, and its chroma divided by its brightness.
  double greenY_ = 0;
  Vector2d tone_ = Vector2d::Zero();
  /// Sums over pixels of the carpet, in which older ones have less weight: of brightness y, squared
  /// distance d from the middle (1 in the corners), and chroma.
  double yy_ = 0, yd_ = 0, dd_ = 0;
  Vector2d yChroma_ = Vector2d::Zero(), dChroma_ = Vector2d::Zero();
  Image corrected_;
  std::vector<std::int16_t> columns_, corners_, gains_, neutral_;  ///< For each byte of a row.
};

}  // namespace gt
