#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "base/Random.h"
#include "debug/Debug.h"
#include "modules/perception/testing/FoundPercepts.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// Images drawn by hand, for tests.

/// The pixel that a camera measures for a color (Y, Cb, Cr), with Gaussian noise.
inline Pixel pixelOf(const Vector3d& color, double noise, Random& random) {
  const auto byte = [&](double v) {
    return static_cast<std::uint8_t>(std::clamp(v + noise * random.gaussian() + 0.5, 0.0, 255.0));
  };
  return {byte(color[0]), byte(color[1]), byte(color[2]), 0};
}

/// Draws the image of a camera. colorAlong returns the color along a ray in the robot's system;
/// `rays` is the number of rays along each side of a pixel.
void drawImage(Image& image, const CameraMatrix& matrix, int rays, double noise, Random& random,
               auto&& colorAlong) {
  image.info = matrix.info;
  image.allocate();
  for (int y = 0; y < image.info.height; ++y)
    for (int x = 0; x < image.info.width; ++x) {
      Vector3d sum = Vector3d::Zero();
      for (int j = 0; j < rays; ++j)
        for (int i = 0; i < rays; ++i)
          sum += colorAlong(matrix.ray(x + (i + 0.5) / rays, y + (j + 0.5) / rays).normalized());
      image.at(x, y) = pixelOf(sum / (rays * rays), noise, random);
    }
}

/// The matrix of a camera without a rolling shutter, at a place (mm, relative to the robot); angles
/// in rad.
inline CameraMatrix cameraAt(const Vector3d& place, double pan, double tilt, double roll) {
  CameraMatrix matrix;
  matrix.pose.rotation = rotationZ(pan) * rotationY(-tilt) * rotationX(roll);
  matrix.pose.translation = place;
  matrix.valid = true;
  matrix.info.rowTime = 0;
  return matrix;
}

/// The colors of color classes, and of pixels without a class.
struct Palette {
  std::vector<std::pair<ColorClass, Pixel>> colors;
  Vector3d background;

  Vector3d operator[](ColorClass c) const {
    for (const auto& [name, p] : colors)
      if (name == c) return {double(p.y), double(p.cb), double(p.cr)};
    return background;
  }
  /// A color table in which colors nearer than `distance` to one of the palette belong to its
  /// class.
  ColorTable64 table(double distance) const {
    ColorTable64 table;
    for (int y = 2; y < 256; y += 4)
      for (int cb = 2; cb < 256; cb += 4)
        for (int cr = 2; cr < 256; cr += 4)
          for (const auto& [name, p] : colors)
            if ((Vector3d(y, cb, cr) - (*this)[name]).norm() < distance)
              table.classes[ColorTable64::index(static_cast<std::uint8_t>(y),
                                                static_cast<std::uint8_t>(cb),
                                                static_cast<std::uint8_t>(cr))] = name;
    return table;
  }
};

/// The percepts that a processor finds in drawn images.
struct DrawnPercepts : FoundPercepts {
  Debug debug{1 << 16};

  /// Calls a processor: update(image, matrix, colors..., percepts, debug).
  void lookWith(auto& processor, const Image& image, const CameraMatrix& matrix,
                const auto&... colorsAndField) {
    processor.update(image, matrix, colorsAndField..., *this, debug);
  }
};

}  // namespace gt
