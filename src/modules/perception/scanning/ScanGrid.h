#pragma once
#include <cstddef>
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// A straight row of pixels, one each step along the axis of the image to which it is closer.
struct ScanLine {
  double u = 0;        ///< Where it crosses the horizon's system of coordinates.
  Vector2d start;      ///< Center of the first pixel along the closer axis.
  Vector2d step;       ///< From pixel to pixel.
  int length = 0;      ///< Pixels.
  bool whole = false;  ///< One of the lines that reach over the whole image.
  bool fromBorder = false, toBorder = false;  ///< Whether its ends lie on the image's border.

  Vector2d at(double i) const { return start + step * i; }
};

/// The pixels of a scan line one after another, in steps of 1/65536 pixel: for the loops that look
/// at all of them.
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

/// How the grid is spread over the image.
struct GridSpacing {
  double dense = 2;  ///< Pixels between lines next to the horizon; twice and four times elsewhere.
  double reachUp = 10;   ///< How far lines reach above the horizon per pixel of their spacing.
  double reachDown = 8;  ///< The same below; four times the dense spacing reaches everywhere.
};

/// The scan lines perpendicular to the horizon, from top to bottom, dense near the horizon and
/// coarse below (report 3.2.1). From left to right.
class ScanGrid {
 public:
  void build(const CameraInfo& info, const Horizon& horizon, const GridSpacing& spacing);
  const std::vector<ScanLine>& lines() const { return lines_; }
  /// A few lines parallel to the horizon, below it; every second one from right to left.
  const std::vector<ScanLine>& rows() const { return rows_; }

 private:
  std::vector<ScanLine> lines_, rows_;
};

/// How many points start + i * step lie in the image before the first one that does not.
int stepsInImage(const CameraInfo& info, const Vector2d& start, const Vector2d& step);

/// The part of a line base + t * direction (a unit vector), low <= t <= high, that lies in the
/// image; length 0 if none does.
ScanLine clippedLine(const CameraInfo& info, const Vector2d& base, const Vector2d& direction,
                     double low, double high);

}  // namespace gt
