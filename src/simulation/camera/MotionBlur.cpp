#include "simulation/camera/MotionBlur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gt {
namespace {

constexpr int channels = 4;
/// What is smeared by the same way: so many pixels in both directions.
constexpr int blockWidth = 16, blockHeight = 8;
/// No way is longer in either direction (pixels).
constexpr int longest = 32;
constexpr int mostSamples = 31;

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

/// The whole pixels from a pixel to those whose mean it gets.
struct Path {
  std::array<int, mostSamples> x, y;
  int count = 0;

  explicit Path(const Vector2d& way)
      : count{1 + std::min(mostSamples - 1,
                           2 * static_cast<int>(std::ceil(way.cwiseAbs().maxCoeff() / 2)))} {
    for (int i = 0; i < count; ++i) {
      const double part = (i + 0.5) / count - 0.5;
      const auto index = static_cast<std::size_t>(i);
      x[index] = std::clamp(static_cast<int>(std::lround(part * way.x())), -longest, longest);
      y[index] = static_cast<int>(std::lround(part * way.y()));
    }
  }
};

}  // namespace

void MotionBlur::apply(const CameraView& view, double exposure, Rasterizer& picture) {
  const Vector3d turn = turnOf(view, exposure);
  constexpr double least = 1e-3;  // rad, a sixth of a pixel
  if (turn.norm() < least) return;
  copySharp(picture);
  for (int y = 0; y < picture.height(); y += blockHeight)
    for (int x = 0; x < picture.width(); x += blockWidth) {
      const Path path{wayAt(view.info, x + blockWidth / 2.0, y + blockHeight / 2.0, turn)};
      const int below = std::min(y + blockHeight, picture.height());
      for (int row = y; row < below && path.count > 1; ++row) {
        std::array<std::uint16_t, channels * blockWidth> sums{};
        for (int i = 0; i < path.count; ++i) {
          const auto index = static_cast<std::size_t>(i);
          const std::uint8_t* from =
              sharpAt(x + path.x[index], std::clamp(row + path.y[index], 0, picture.height() - 1));
          for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] = static_cast<std::uint16_t>(sums[k] + from[k]);
        }
        std::array<std::uint8_t, channels * blockWidth> means{};
        const auto share = static_cast<std::uint32_t>((1 << 16) / path.count + 1);
        for (std::size_t k = 0; k < sums.size(); ++k)
          means[k] = static_cast<std::uint8_t>(
              (sums[k] + static_cast<std::uint32_t>(path.count) / 2) * share >> 16);
        PackedColor* out = picture.row(row) + x;
        for (int k = 0; k < std::min(blockWidth, picture.width() - x); ++k) {
          PackedColor mean = 0;
          std::memcpy(&mean, &means[static_cast<std::size_t>(channels * k)], channels);
          out[k] = (out[k] & 0xff000000) | (mean & 0x00ffffff);
        }
      }
    }
}

void MotionBlur::copySharp(const Rasterizer& picture) {
  const int width = picture.width();
  stride_ = width + 2 * longest + blockWidth;
  sharp_.resize(static_cast<std::size_t>(stride_ * picture.height()));
  for (int y = 0; y < picture.height(); ++y) {
    PackedColor* row = &sharp_[static_cast<std::size_t>(y * stride_)];
    std::fill_n(row, longest, picture.row(y)[0]);
    std::copy_n(picture.row(y), width, row + longest);
    std::fill_n(row + longest + width, longest + blockWidth, picture.row(y)[width - 1]);
  }
}

const std::uint8_t* MotionBlur::sharpAt(int x, int y) const {
  return reinterpret_cast<const std::uint8_t*>(
      &sharp_[static_cast<std::size_t>(y * stride_ + longest + x)]);
}

}  // namespace gt
