#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// A set of color classes.
class ColorSet {
 public:
  constexpr ColorSet() = default;
  template <typename... C>
  constexpr explicit ColorSet(C... classes) : bits_((... | bit(classes))) {}
  constexpr bool contains(ColorClass c) const { return (bits_ & bit(c)) != 0; }

 private:
  static constexpr std::uint32_t bit(ColorClass c) { return 1u << static_cast<int>(c); }
  std::uint32_t bits_ = 0;
};

/// The point where a color ends on a path through the image.
struct ColorEdge {
  /// In pixels, with subpixel accuracy; pixels are squares of size 1.
  Vector2d point = Vector2d::Zero();
  bool onBorder = false;  ///< Whether the color reaches the image's border.
};

/// A path that was followed through the image, for drawings.
struct ScanPath {
  Vector2d start;
  ColorEdge end;
};

/// Prefetches the whole image into the cache in the order of memory. Scan lines run across its rows
/// and would otherwise wait for memory at each pixel.
inline void fetch(const Image& image) {
  constexpr std::size_t cacheLine = 64;
  const auto* const bytes = reinterpret_cast<const char*>(image.pixels.data());
  for (std::size_t i = 0; i < image.pixels.size() * sizeof(Pixel); i += cacheLine)
    __builtin_prefetch(bytes + i);
}

/// The point in the image (pixels) at which a direction in the robot's system is seen, with the
/// camera's pose at the exposure of that row. The ray must point forward.
Vector2d pointIn(const CameraMatrix& matrix, const Vector3d& ray);

/// A camera image with the data needed to interpret it: its color table, its camera matrix, its
/// horizon.
struct CameraImage {
  const Image& image;
  const ColorTable64& colors;
  const CameraMatrix& matrix;
  const Horizon& horizon;
  /// Receives all paths if a drawing is requested; otherwise null.
  std::vector<ScanPath>* paths = nullptr;

  bool contains(const Vector2d& p) const { return image.info.contains(p.x(), p.y()); }
  const Pixel& pixelAt(const Vector2d& p) const {
    return image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
  }
  ColorClass classAt(const Vector2d& p) const { return colors[pixelAt(p)]; }
  /// The unit vector, in the robot's system, from the camera to a point of the image (pixels), with
  /// the camera's pose at the exposure of the point's row.
  Vector3d ray(const Vector2d& p) const { return matrix.ray(p.x(), p.y()).normalized(); }
  /// The point in the image (pixels) at which a direction in the robot's system is seen. The ray
  /// must point forward.
  Vector2d pointOf(const Vector3d& ray) const { return pointIn(matrix, ray); }

  /// Follows a path from a point in a color to the end of the color (report 3.2.4, 3.2.5), the last
  /// pixel of one of the classes. Gaps of up to maxGap pixels are skipped. The end is refined to a
  /// fraction of a pixel, where the image is halfway between the colors of both sides.
  ColorEdge findEdge(const Vector2d& start, const Vector2d& direction, ColorSet classes,
                     int maxGap) const {
    return findEdgeOf(start, direction, maxGap,
                      [&](const Pixel&, ColorClass c) { return classes.contains(c); });
  }
  /// Like findEdge, for all pixels that belongs(pixel, class) accepts.
  template <typename Belongs>
  ColorEdge findEdgeOf(const Vector2d& start, const Vector2d& direction, int maxGap,
                       Belongs belongs) const {
    ColorEdge edge;
    Vector2d p = start;
    int last = 0;
    for (int i = 0;; ++i, p += direction) {
      if (!contains(p)) {
        // The border cuts the color off where the color was seen next to it.
        edge.onBorder = i - last <= 2;
        break;
      }
      const Pixel& pixel = image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
      const ColorClass c = colors[pixel];
      if (belongs(pixel, c)) {
        last = i;
      } else if (i > last + maxGap) {
        break;
      }
    }
    edge.point =
        edge.onBorder ? Vector2d{start + direction * last} : refineEdge(start, direction, last);
    if (paths) paths->push_back({start, edge});
    return edge;
  }

  /// The color (Y, Cb, Cr) between pixel centers, interpolated.
  Vector3d colorAt(const Vector2d& p) const;

 private:
  Vector2d refineEdge(const Vector2d& start, const Vector2d& direction, int last) const;
};

/// The angle of a direction in the robot's system to the left of straight ahead (rad).
inline double azimuth(const Vector3d& ray) {
  return std::atan2(ray.y(), ray.x());
}
/// The angle of a direction in the robot's system above the horizon (rad).
inline double elevation(const Vector3d& ray) {
  return std::atan2(ray.z(), std::hypot(ray.x(), ray.y()));
}

}  // namespace gt
