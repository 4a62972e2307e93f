#include "modules/perception/scanning/Horizon.h"

namespace gt {

// A point (x, y) of the image lies on the horizon where its ray is parallel to the ground:
// r31 + r32 (cx - x) / fx + r33 (cy - y) / fy = 0, which is formula 3.5 solved for any x.
Horizon horizonOf(const CameraMatrix& matrix) {
  const CameraInfo& info = matrix.info;
  const Matrix3d& r = matrix.pose.rotation;
  const Vector2d gradient{r(2, 1) / info.focalX, r(2, 2) / info.focalY};
  const double slope = gradient.norm();
  Horizon horizon;
  // Looking straight up or down there is no horizon; any far away one does.
  constexpr double flattest = 1e-6;
  if (slope > flattest) horizon.down = gradient / slope;
  horizon.along = {horizon.down.y(), -horizon.down.x()};
  horizon.base =
      Vector2d{info.centerX, info.centerY} + horizon.down * (r(2, 0) / std::max(slope, flattest));
  if (!info.distortion().none()) {
    // A lens bends the horizon; next to the optical axis it stays parallel to itself.
    const Vector2d center{info.centerX, info.centerY};
    horizon.base = center + info.distorted(horizon.base - center);
  }
  return horizon;
}

}  // namespace gt
