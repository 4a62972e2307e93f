#include "modules/perception/scanning/CameraImage.h"

#include <algorithm>

namespace gt {

Vector2d pointIn(const CameraMatrix& matrix, const Vector3d& ray) {
  // The row decides on the rotation, which decides on the row: twice is close enough.
  const auto project = [&](const Matrix3d& rotation) {
    const Vector3d inCamera = rotation.transpose() * ray;
    return matrix.info.project({std::max(inCamera.x(), 1e-3), inCamera.y(), inCamera.z()});
  };
  Vector2d p = project(matrix.pose.rotation);
  for (int i = 0; i < 2; ++i)
    p = project(matrix.rotationAt(std::clamp<double>(p.y(), 0, matrix.info.height)));
  return p;
}

Vector3d CameraImage::colorAt(const Vector2d& p) const {
  const double x = std::clamp(p.x() - 0.5, 0.0, image.info.width - 1.001);
  const double y = std::clamp(p.y() - 0.5, 0.0, image.info.height - 1.001);
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const double fx = x - ix, fy = y - iy;
  const int right = std::min(ix + 1, image.info.width - 1);
  const int below = std::min(iy + 1, image.info.height - 1);
  const auto color = [](const Pixel& pixel) { return Vector3d(pixel.y, pixel.cb, pixel.cr); };
  return (color(image.at(ix, iy)) * (1 - fx) + color(image.at(right, iy)) * fx) * (1 - fy) +
         (color(image.at(ix, below)) * (1 - fx) + color(image.at(right, below)) * fx) * fy;
}

Vector2d CameraImage::refineEdge(const Vector2d& start, const Vector2d& direction, int last) const {
  constexpr double reach = 2, step = 0.5;
  const Vector2d at = start + direction * last;
  // Both sides' colors, far enough away not to be mixed by blur.
  const Vector3d inside = colorAt(at - direction * std::min<double>(reach, last));
  const Vector3d outside = colorAt(at + direction * (reach + 1));
  const Vector3d axis = outside - inside;
  const double contrast = axis.squaredNorm();
  if (contrast < 100) return at + direction * 0.5;
  double before = 0;
  for (double t = -std::min<double>(reach, last) + step; t <= reach + 1; t += step) {
    const double now = (colorAt(at + direction * t) - inside).dot(axis) / contrast;
    if (now >= 0.5) return at + direction * (t - step * (now - 0.5) / std::max(now - before, 1e-6));
    before = now;
  }
  return at + direction * 0.5;
}

}  // namespace gt
