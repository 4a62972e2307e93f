#pragma once
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// The horizon in an image and the system of coordinates along it (report 3.2.1), in pixels.
struct Horizon {
  Vector2d base = Vector2d::Zero();  ///< The horizon's point nearest to the optical axis.
  Vector2d along{1, 0};              ///< Unit vector to the right.
  Vector2d down{0, 1};               ///< Unit vector towards the ground.

  /// Conversion from (u, v) along and below the horizon to a point in the image, and back.
  Vector2d toPicture(double u, double v) const { return base + along * u + down * v; }
  Vector2d fromImage(const Vector2d& p) const { return {along.dot(p - base), down.dot(p - base)}; }
};

/// The horizon at the exposure of the middle row (report 3.2.1, formulas 3.1 to 3.6).
Horizon horizonOf(const CameraMatrix& matrix);

}  // namespace gt
