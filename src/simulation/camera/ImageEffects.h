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
  /// The same input gives the same bytes. `image` and `view`, in which the image was drawn, have
  /// the size of the planes.
  void apply(const ImagePlanes& picture, const CameraView& view, const CameraEffects& effects,
             std::uint64_t seed, Image& image);

 private:
  template <typename T>
  using Rows = std::array<std::vector<T>, channelCount>;

  /// What depends on the column only.
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
  /// The light of each pixel of a row that lies so far outward.
  void lightRow(const CameraEffects& effects, int y, double out);

  ImagePlanes spread_;
  Plane mixed_, mixedRows_;  ///< Between two passes; a whole image and a row of each channel.
  Rows<std::uint8_t> blurred_, shaded_;
  std::vector<std::int16_t> gain_, uneven_, light_;  ///< Of each column.
  Rows<std::int16_t> cast_;                          ///< Of each column.
  int width_ = 0;                                    ///< For which columns were set,
  CameraEffects known_;                              ///< and these.
  Rows<std::int16_t> noise_;  ///< Rows of images begin anywhere in it. Made for `correlation_`.
  double correlation_ = -1;
  Rows<std::int16_t> added_;  ///< Noise and color casts that are steady, made for `steady_`.
  CameraEffects steady_;
  UnevenLight unevenLight_;
};

}  // namespace gt
