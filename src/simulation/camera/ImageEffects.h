#pragma once
#include <cstdint>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// Turns a perfect image into what the camera delivers: blurred by the lens, darker in the
/// corners, with a color cast and noisy.
class ImageEffects {
 public:
  /// The same input gives the same bytes. `image` has the rasterizer's size.
  void apply(const Rasterizer& picture, const CameraEffects& effects, std::uint64_t seed,
             Image& image);
  /// The perfect image.
  static void copy(const Rasterizer& picture, Image& image);

 private:
  void setTables(int width, const CameraEffects& effects);
  void setLight(int width, const CameraEffects& effects);
  void setNoise(const CameraEffects& effects);
  const std::uint8_t* blurRow(const Rasterizer& picture, int y, int weight);

  // Four entries for each pixel of a row: y, cb, cr and the unused byte. Made for `known_`.
  std::vector<std::int16_t> offset_, gain_;
  std::vector<std::int16_t> added_;  ///< Noise and color cast, an image takes rows of it.
  std::vector<std::uint8_t> vertical_, blurred_;
  int width_ = 0;
  CameraEffects known_;
};

}  // namespace gt
