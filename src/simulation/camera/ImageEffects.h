#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraView.h"
#include "simulation/camera/Rasterizer.h"
#include "simulation/camera/UnevenLight.h"

namespace gt {

/// Turns a perfect image into what the camera delivers: blurred by the lens, its colors bleeding,
/// darker and bluish in the corners, lit unevenly, with a color cast and noisy.
class ImageEffects {
 public:
  /// The same input gives the same bytes. `image` and `view`, in which the image was drawn, have
  /// the rasterizer's size.
  void apply(const Rasterizer& picture, const CameraView& view, const CameraEffects& effects,
             std::uint64_t seed, Image& image);
  /// The perfect image.
  static void copy(const Rasterizer& picture, Image& image);

 private:
  void setTables(int width, const CameraEffects& effects);
  void setLight(int width, const CameraEffects& effects);
  void setNoise(const CameraEffects& effects);
  void setAdded(const CameraEffects& effects);
  void setRim(int width, const CameraEffects& effects);
  /// A row with the colors that bleed into it.
  const std::uint8_t* colorRow(const Rasterizer& picture, int y);
  const std::uint8_t* blurRow(const Rasterizer& picture, int y, int weight);
  void prepareRow(const std::uint8_t* in, int y, int height, std::int16_t rowLoss);

  // Four entries for each pixel of a row: y, cb, cr and the unused byte. Made for `known_`.
  std::vector<std::int16_t> offset_, gain_;
  std::vector<std::int16_t> added_;  ///< Noise and color cast, an image takes rows of it.
  std::vector<std::int16_t> noise_;  ///< Four times the noise where y is 0, likewise.
  std::vector<std::int16_t> columnCast_, rowCast_, rowLight_, rowNoise_;
  std::vector<std::int16_t> uneven_;  ///< An entry for each pixel of a row.
  UnevenLight light_;
  std::vector<std::uint8_t> vertical_, blurred_;
  std::array<std::vector<std::uint8_t>, 3> bled_;  ///< The last rows of `colorRow`,
  std::array<int, 3> bledRow_{};                   ///< and which they are.
  int width_ = 0;
  CameraEffects known_;
};

}  // namespace gt
