#include "simulation/camera/UnevenLight.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr int apart = 16;                                 // pixels
constexpr double one = 1 << 14;                           // a light as on average
constexpr double farthest = 3000;                         // mm, from the robot and the center
constexpr double lampsApartX = 2600, lampsApartY = 1900;  // mm

}  // namespace

double UnevenLight::at(const Vector2d& place) {
  return 0.6 * std::sin(2 * pi * place.x() / lampsApartX + 0.6) +
         0.4 * std::sin(2 * pi * place.y() / lampsApartY - 0.4);
}

void UnevenLight::set(const CameraView& view, double share) {
  width_ = view.info.width;
  columns_ = (view.info.width + apart - 1) / apart + 1;
  const int rows = (view.info.height + apart - 1) / apart + 1;
  points_.clear();
  for (int r = 0; r < rows; ++r) {
    const double part = std::min(1.0, static_cast<double>(r * apart) / view.info.height);
    const Pose3D pose = interpolated(view.first, view.last, part);
    for (int c = 0; c < columns_; ++c) {
      const Vector3d ray = pose.rotation * view.info.ray(c * apart, r * apart);
      double far = farthest / std::max(ray.head<2>().norm(), 1e-3);
      if (ray.z() < 0) far = std::min(far, -pose.translation.z() / ray.z());
      const Vector2d seen = (pose.translation + far * ray).head<2>();
      const Vector2d place = seen.cwiseMax(-farthest).cwiseMin(farthest);
      points_.push_back(static_cast<std::int16_t>(one * (1 + share * at(place))));
    }
  }
}

void UnevenLight::row(int y, std::int16_t* light) const {
  const int below = y % apart;
  const std::int16_t* upper = &points_[static_cast<std::size_t>(y / apart * columns_)];
  const std::int16_t* lower = upper + columns_;
  const auto between = [&](int c) { return upper[c] + (lower[c] - upper[c]) * below / apart; };
  int right = between(0);
  for (int x = 0, c = 0; x < width_; ++c) {
    const int left = right;
    right = between(c + 1);
    for (int k = 0; k < apart && x < width_; ++k, ++x)
      light[x] = static_cast<std::int16_t>(left + (right - left) * k / apart);
  }
}

}  // namespace gt
