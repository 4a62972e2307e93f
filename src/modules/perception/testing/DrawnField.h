#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "modules/perception/testing/DrawnImage.h"

namespace gt {

/// The colors of a field by daylight.
inline const Vector3d fieldGreen{77, 113, 82}, fieldWhite{230, 128, 128}, fieldBlack{16, 128, 128};

/// The color along a ray of a camera 170 mm above green ground with lines across and a white wall
/// behind.
inline Vector3d fieldAt(const Vector3d& ray) {
  if (ray.z() >= -0.02) return ray.z() < 0.05 ? fieldWhite : fieldBlack;
  const double x = 170 * ray.x() / -ray.z();
  return std::fmod(x, 700) < 40 ? fieldWhite : fieldGreen;
}

/// A color table for green, white, black and gray.
inline ColorTable64 blackWhiteTable() {
  ColorTable64 table;
  for (int y = 2; y < 256; y += 4)
    for (int cb = 2; cb < 256; cb += 4)
      for (int cr = 2; cr < 256; cr += 4) {
        const bool isGreen = cr < 112;
        table.classes[ColorTable64::index(
            static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(cb),
            static_cast<std::uint8_t>(cr))] = isGreen   ? ColorClass::green
                                              : y > 150 ? ColorClass::white
                                              : y < 60  ? ColorClass::black
                                                        : ColorClass::gray;
      }
  return table;
}

/// An image from 170 mm above the ground.
struct DrawnField {
  CameraMatrix matrix;
  Image image;

  explicit DrawnField(double tilt = -0.3, double roll = 0)
      : matrix{cameraAt({0, 0, 170}, 0, tilt, roll)} {}

  /// Draws an image in another light: `light` is the factor to brightness and saturation of each
  /// color.
  void draw(const std::function<Vector3d(const Vector3d&)>& colorAlong, double light, double noise,
            Random& random) {
    drawImage(image, matrix, 3, noise, random,
              [&](const Vector3d& ray) { return lit(colorAlong(ray), light); });
  }
  static Vector3d lit(const Vector3d& color, double light) {
    const Vector3d gray{0, 128, 128};
    return gray + light * (color - gray);
  }
};

}  // namespace gt
