#include "simulation/camera/MotionBlur.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "base/WideInstructions.h"

namespace gt {
namespace {

/// Size of a block (pixels), which is smeared over one distance.
constexpr int blockWidth = Plane::step, blockHeight = 8;
/// Greatest distance to either side (pixels).
constexpr int longest = Plane::margin - blockWidth;
constexpr std::size_t mostSamples = 16;

/// The rotation vector of the camera during `exposure` (ms), in its own axes (rad).
Vector3d turnOf(const CameraView& view, double exposure) {
  const double duration = (view.info.height - 1) * view.info.rowTime;
  if (duration <= 0) return Vector3d::Zero();
  const Eigen::AngleAxisd turn{view.first.rotation.transpose() * view.last.rotation};
  return turn.axis() * turn.angle() * exposure / duration;
}

/// The motion (pixels) of a point seen at (x, y) in the image when the camera turns.
Vector2d motionAt(const CameraInfo& info, double x, double y, const Vector3d& turn) {
  const Vector3d ray = info.ray(x, y);
  const Vector3d change = -turn.cross(ray);
  return {-info.focalX * (change.y() - ray.y() * change.x()),
          -info.focalY * (change.z() - ray.z() * change.x())};
}

int rounded(double pixels) {
  return static_cast<int>(pixels + longest + 0.5) - longest;
}

/// Offsets (whole pixels) from a pixel to the 1, 4, 8 or 16 pixels whose mean it gets.
struct Path {
  std::array<int, mostSamples> x, y;
  std::size_t count = 0;

  explicit Path(const Vector2d& motion) {
    const double length = motion.cwiseAbs().maxCoeff();
    count = length < 0.6 ? 1 : length <= 4 ? 4 : length <= 8 ? 8 : mostSamples;
    const Vector2d most = motion.cwiseMax(-2 * longest).cwiseMin(2 * longest);
    for (std::size_t i = 0; i < count; ++i) {
      const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(count) - 0.5;
      x[i] = rounded(part * most.x());
      y[i] = rounded(part * most.y());
    }
  }
};

/// Offsets (bytes) from a pixel of a plane to the pixels whose mean it gets.
using Offsets = std::array<std::ptrdiff_t, mostSamples>;

/// Writes the means of `count` pixels each.
template <std::size_t count>
struct Mean {
  const std::uint8_t* sharp;
  const Offsets& offsets;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict out,
                                                std::size_t size) const {
    for (std::size_t k = 0; k < size; ++k) {
      std::uint16_t sum = count / 2;
      for (std::size_t i = 0; i < count; ++i)
        sum = static_cast<std::uint16_t>(sum + sharp[offsets[i] + static_cast<std::ptrdiff_t>(k)]);
      out[k] = static_cast<std::uint8_t>(sum / count);
    }
  }
};

/// Smears a row of a block.
[[gnu::always_inline]] inline void smear(const std::uint8_t* sharp, const Offsets& offsets,
                                         std::size_t count, std::uint8_t* out) {
  if (count == 1)
    std::memcpy(out, sharp + offsets[0], blockWidth);
  else if (count == 4)
    Mean<4>{sharp, offsets}(out, blockWidth);
  else if (count == 8)
    Mean<8>{sharp, offsets}(out, blockWidth);
  else
    Mean<mostSamples>{sharp, offsets}(out, blockWidth);
}

}  // namespace

void MotionBlur::apply(const CameraView& view, double exposure, ImagePlanes& picture) {
  const Vector3d turn = turnOf(view, exposure);
  constexpr double least = 1e-3;  // rad, a sixth of a pixel
  if (turn.norm() < least) return;
  std::swap(picture, sharp_);
  for (std::size_t channel = 0; channel < picture.size(); ++channel) {
    picture[channel].resize(view.info.width, view.info.height);
    for (int y = 0; y < view.info.height; ++y) sharp_[channel].fillMargins(y);
  }
  withWideInstructions([&]() __attribute__((always_inline)) {
    for (int y = 0; y < view.info.height; y += blockHeight)
      for (int x = 0; x < view.info.width; x += blockWidth) {
        const Path path{motionAt(view.info, x + blockWidth / 2.0, y + blockHeight / 2.0, turn)};
        for (int row = y; row < std::min(y + blockHeight, view.info.height); ++row) {
          const std::uint8_t* const first = sharp_[0].row(0);
          Offsets offsets;
          for (std::size_t i = 0; i < path.count; ++i)
            offsets[i] = sharp_[0].nearestRow(row + path.y[i]) - first + x + path.x[i];
          for (std::size_t channel = 0; channel < picture.size(); ++channel)
            smear(sharp_[channel].row(0), offsets, path.count, picture[channel].row(row) + x);
        }
      }
  });
}

}  // namespace gt
