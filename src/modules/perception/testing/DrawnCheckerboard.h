#pragma once
#include "modules/perception/calibration/CheckerboardFinder.h"
#include "modules/perception/scanning/CameraImage.h"
#include "modules/perception/testing/DrawnField.h"

namespace gt {
/// A checkerboard that stands upright in front of the camera.
struct DrawnCheckerboard {
  Checkerboard board;
  /// The color (Y, Cb, Cr) along a ray if the board stands at x = distance (mm).
  Vector3d colorAt(const Vector3d& ray, double distance) const {
    if (ray.x() <= 0) return fieldGreen;
    const double y = ray.y() / ray.x() * distance, z = 170 + ray.z() / ray.x() * distance;
    const double u = (board.columns + 1) / 2.0 - y / board.square;
    const double v = 1 + (z - board.height) / board.square;
    if (u < -0.5 || v < -0.5 || u > board.columns + 1.5 || v > board.rows + 1.5) return fieldGreen;
    if (u < 0 || v < 0 || u > board.columns + 1 || v > board.rows + 1) return fieldWhite;
    return (static_cast<int>(u) + static_cast<int>(v)) % 2 == 0 ? fieldBlack : fieldWhite;
  }
  Vector3d cornerAt(int column, int row, double distance) const {
    return {distance, ((board.columns - 1) / 2.0 - column) * board.square,
            board.height + (board.rows - 1 - row) * board.square};
  }
};

}  // namespace gt
