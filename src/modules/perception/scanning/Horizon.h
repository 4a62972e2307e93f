#pragma once
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// The horizon in an image and the system of coordinates along it (report 3.2.1). Distances in
/// pixels.
struct Horizon {
  Vector2d base = Vector2d::Zero();  ///< The horizon's point nearest to the optical axis.
  Vector2d along{1, 0};              ///< To the right.
  Vector2d down{0, 1};               ///< To the ground.

  Vector2d toPicture(double u, double v) const { return base + along * u + down * v; }
  Vector2d fromImage(const Vector2d& p) const { return {along.dot(p - base), down.dot(p - base)}; }
};

/// The horizon when the middle row was exposed (report 3.2.1, formulas 3.1 to 3.6).
Horizon horizonOf(const CameraMatrix& matrix);

}  // namespace gt
