#include "simulation/camera/UnevenLight.h"

#include <algorithm>
#include <cmath>

#include "base/WideInstructions.h"

namespace gt {
namespace {

constexpr int apartBits = 4, apart = 1 << apartBits;      // pixels
constexpr double one = 1 << 14;                           // a light as on average
constexpr double farthest = 3000;                         // mm, from the robot and the center
constexpr double lampsApartX = 2600, lampsApartY = 1900;  // mm

/// Interpolates between the points of two rows.
struct Interpolate {
  const std::int16_t *upper, *lower;
  int below;

  [[gnu::always_inline]] inline void operator()(std::int16_t* __restrict out,
                                                std::size_t points) const {
    const auto between = [&](std::size_t c) {
      return upper[c] + ((lower[c] - upper[c]) * below >> apartBits);
    };
    for (std::size_t c = 0; c < points; ++c) {
      const int left = between(c), right = between(c + 1);
      for (int k = 0; k < apart; ++k)
        out[apart * c + static_cast<std::size_t>(k)] =
            static_cast<std::int16_t>(left + ((right - left) * k >> apartBits));
    }
  }
};

}  // namespace

double UnevenLight::at(const Vector2d& place) {
  return 0.6 * std::sin(2 * pi * place.x() / lampsApartX + 0.6) +
         0.4 * std::sin(2 * pi * place.y() / lampsApartY - 0.4);
}

void UnevenLight::set(const CameraView& view, double share) {
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
  const std::int16_t* upper = &points_[static_cast<std::size_t>(y / apart * columns_)];
  withWideInstructions([&]() __attribute__((always_inline)) {
    Interpolate{upper, upper + columns_, y % apart}(light, static_cast<std::size_t>(columns_ - 1));
  });
}

}  // namespace gt
