#pragma once
#include <vector>

#include "modules/perception/Horizon.h"

namespace gt {

/// A straight row of pixels, one each step along the axis of the picture to which it is closer.
struct ScanLine {
  double u = 0;        ///< Where it crosses the horizon's system of coordinates.
  Vector2d start;      ///< Centre of the first pixel along the closer axis.
  Vector2d step;       ///< From pixel to pixel.
  int length = 0;      ///< Pixels.
  bool whole = false;  ///< One of the lines that reach over the whole picture.
  bool fromBorder = false, toBorder = false;  ///< Whether its ends lie on the picture's border.

  Vector2d at(double i) const { return start + step * i; }
};

/// How the grid is spread over the picture.
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

/// The part of a line base + t * direction (a unit vector), low <= t <= high, that lies in the
/// picture; length 0 if none does.
ScanLine clippedLine(const CameraInfo& info, const Vector2d& base, const Vector2d& direction,
                     double low, double high);

}  // namespace gt
