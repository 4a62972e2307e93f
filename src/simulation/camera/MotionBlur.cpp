#include "simulation/camera/MotionBlur.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// How the camera turns while a row is exposed, in its own axes (rad).
Vector3d turnOf(const CameraView& view, double exposure) {
  const double duration = (view.info.height - 1) * view.info.rowTime;
  if (duration <= 0) return Vector3d::Zero();
  const Eigen::AngleAxisd turn{view.first.rotation.transpose() * view.last.rotation};
  return turn.axis() * turn.angle() * exposure / duration;
}

/// How far what is seen at a place goes in the image if the camera turns.
Vector2d wayAt(const CameraInfo& info, double x, double y, const Vector3d& turn) {
  const Vector3d ray = info.ray(x, y);
  const Vector3d change = -turn.cross(ray);
  return {-info.focalX * (change.y() - ray.y() * change.x()),
          -info.focalY * (change.z() - ray.z() * change.x())};
}

}  // namespace

void MotionBlur::apply(const CameraView& view, double exposure, Rasterizer& picture) {
  const Vector3d turn = turnOf(view, exposure);
  constexpr double least = 1e-3;  // rad, a sixth of a pixel
  if (turn.norm() < least) return;
  const int width = picture.width(), height = picture.height();
  sharp_.clear();
  for (int y = 0; y < height; ++y)
    sharp_.insert(sharp_.end(), picture.row(y), picture.row(y) + width);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vector2d way = wayAt(view.info, x + 0.5, y + 0.5, turn);
      const int samples =
          1 + std::min(30, 2 * static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff() / 2)));
      unsigned sums[3] = {};
      for (int i = 0; i < samples; ++i) {
        const double part = (i + 0.5) / samples - 0.5;
        const auto at = [](double value, int size) {
          return std::clamp(static_cast<int>(std::lround(value)), 0, size - 1);
        };
        const int from = at(y + part * way.y(), height) * width + at(x + part * way.x(), width);
        const PackedColor color = sharp_[static_cast<std::size_t>(from)];
        for (int k = 0; k < 3; ++k) sums[k] += color >> (8 * k) & 0xff;
      }
      const auto n = static_cast<unsigned>(samples);
      PackedColor& pixel = picture.row(y)[x];
      pixel &= 0xff000000;
      for (int k = 0; k < 3; ++k) pixel |= ((sums[k] + n / 2) / n) << (8 * k);
    }
}

}  // namespace gt
