#pragma once
#include <cstddef>
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// A straight line of pixels: one pixel for each step along the image axis to which the line is
/// closer.
struct ScanLine {
  /// Coordinate `u` of the line in the horizon's system of coordinates, pixels.
  double u = 0;
  Vector2d start;      ///< First point, at the center of a pixel along the closer axis.
  Vector2d step;       ///< Vector from one pixel to the next.
  int length = 0;      ///< Number of pixels.
  bool whole = false;  ///< Whether it is one of the lines that cross the whole image.
  bool fromBorder = false, toBorder = false;  ///< Whether its ends lie on the image's border.

  Vector2d at(double i) const { return start + step * i; }
};

/// Iterates over the pixels of a scan line in fixed-point numbers (1/65536 pixel), for loops that
/// read all of them.
class PixelWalk {
 public:
  PixelWalk(const Image& image, const ScanLine& line)
      : pixels_{image.pixels.data()},
        width_{image.info.width},
        x_{fixed(line.start.x())},
        y_{fixed(line.start.y())},
        stepX_{fixed(line.step.x())},
        stepY_{fixed(line.step.y())} {}

  const Pixel& pixel() const { return pixels_[(y_ >> 16) * width_ + (x_ >> 16)]; }
  void step() {
    x_ += stepX_;
    y_ += stepY_;
  }

 private:
  static std::ptrdiff_t fixed(double value) { return static_cast<std::ptrdiff_t>(value * 65536); }

  const Pixel* pixels_;
  std::ptrdiff_t width_, x_, y_, stepX_, stepY_;
};

/// Spacing and reach of the scan lines of a grid.
struct GridSpacing {
  /// Pixels between lines next to the horizon; two and four times that elsewhere.
  double dense = 2;
  double reachUp = 10;  ///< Pixels that lines reach above the horizon per pixel of their spacing.
  /// Pixels below the horizon per pixel of spacing; lines with four times the dense spacing reach
  /// everywhere.
  double reachDown = 8;
};

/// The scan lines of an image, aligned with the horizon (report 3.2.1).
class ScanGrid {
 public:
  void build(const CameraInfo& info, const Horizon& horizon, const GridSpacing& spacing);
  /// The lines perpendicular to the horizon, from left to right, each from top to bottom; dense
  /// near the horizon and coarse below.
  const std::vector<ScanLine>& lines() const { return lines_; }
  /// A few lines parallel to the horizon, below it; every second one from right to left.
  const std::vector<ScanLine>& rows() const { return rows_; }

 private:
  std::vector<ScanLine> lines_, rows_;
};

/// The number of points start + i * step that lie in the image before the first one outside.
int stepsInImage(const CameraInfo& info, const Vector2d& start, const Vector2d& step);

/// The part of a line base + t * direction (a unit vector), low <= t <= high, that lies in the
/// image (pixels); length 0 if no part does.
ScanLine clippedLine(const CameraInfo& info, const Vector2d& base, const Vector2d& direction,
                     double low, double high);

}  // namespace gt
