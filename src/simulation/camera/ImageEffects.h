#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "representations/infrastructure/Image.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraView.h"
#include "simulation/camera/ImagePlanes.h"
#include "simulation/camera/UnevenLight.h"

namespace gt {

/// Turns a perfect image into what the camera delivers: blurred by the lens, its colors bleeding,
/// darker and bluish in the corners, lit unevenly, with a color cast and noisy.
class ImageEffects {
 public:
  /// Writes the result into `image`. The same input gives the same bytes. `view` is the view in
  /// which `picture` was drawn; `image` and `view` have the size of the planes.
  void apply(const ImagePlanes& picture, const CameraView& view, const CameraEffects& effects,
             std::uint64_t seed, Image& image);

 private:
  template <typename T>
  using Rows = std::array<std::vector<T>, channelCount>;

  /// Computes the tables that depend on the column only.
  void setColumns(const CameraEffects& effects, int width, std::size_t padded);
  void setNoise(const CameraEffects& effects);
  void applyWide(const ImagePlanes& picture, const CameraEffects& effects, std::uint64_t seed,
                 Image& image);
  struct Spread;
  /// Mixes the rows of a plane with those above and below, in all passes but the last. The result
  /// is in `out` unless nothing changes.
  const Plane& spreadRows(const Plane& plane, const Spread& spread, Plane& out);
  /// Mixes a row with those above and below, in the last pass. The result is in `out` unless
  /// nothing changes.
  static const std::uint8_t* spreadAcross(const Plane& plane, int y, const Spread& across,
                                          std::uint8_t* out);
  /// Mixes pixels of a row with those beside them, with `middle` between two passes. The result is
  /// in `out` unless nothing changes.
  const std::uint8_t* spreadAlong(const std::uint8_t* row, const Spread& along,
                                  std::uint8_t* middle, std::uint8_t* out);
  /// Computes the light of each pixel of a row. `out` is half of the row's squared distance from
  /// the image's middle, as a share of half the height.
  void lightRow(const CameraEffects& effects, int y, double out);

  ImagePlanes spread_;
  Plane mixed_, mixedRows_;  ///< Results between two passes: an image, and a row of each channel.
  Rows<std::uint8_t> blurred_, shaded_;
  std::vector<std::int16_t> gain_, uneven_, light_;  ///< Of each column.
  Rows<std::int16_t> cast_;                          ///< Of each column.
  int width_ = 0;                                    ///< For which the columns were set.
  CameraEffects known_;                              ///< For which the columns were set.
  Rows<std::int16_t> noise_;  ///< Noise for `correlation_`; rows of images begin anywhere in it.
  double correlation_ = -1;
  Rows<std::int16_t> added_;  ///< Noise and color casts that are steady, made for `steady_`.
  CameraEffects steady_;
  UnevenLight unevenLight_;
};

}  // namespace gt
