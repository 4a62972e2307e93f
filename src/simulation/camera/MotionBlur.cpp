#include "simulation/camera/MotionBlur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gt {
namespace {

constexpr int channels = 4;
/// What is smeared over the same distance: so many pixels in both directions.
constexpr int blockWidth = 16, blockHeight = 8;
/// No distance is longer in either direction (pixels).
constexpr int longest = 32;
constexpr int mostSamples = 16;

/// The bytes of a row of a block.
using BlockRow = std::array<std::uint8_t, channels * blockWidth>;

/// Averages bytes with others; halves are rounded up or down.
void average(BlockRow& bytes, const BlockRow& others, bool up) {
  const std::uint8_t flip = up ? 0 : 255;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const auto one = static_cast<std::uint8_t>(bytes[k] ^ flip);
    const auto two = static_cast<std::uint8_t>(others[k] ^ flip);
    bytes[k] = static_cast<std::uint8_t>(static_cast<std::uint8_t>((one + two + 1) >> 1) ^ flip);
  }
}

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

/// The whole pixels from a pixel to those whose mean it gets: 1, 4, 8 or 16.
struct Path {
  std::array<int, mostSamples> x, y;
  int count = 0;

  explicit Path(const Vector2d& way) {
    const double length = way.cwiseAbs().maxCoeff();
    count = length < 0.6 ? 1 : length <= 4 ? 4 : length <= 8 ? 8 : mostSamples;
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
  std::array<BlockRow, mostSamples> samples{};
  for (int y = 0; y < picture.height(); y += blockHeight)
    for (int x = 0; x < picture.width(); x += blockWidth) {
      const Path path{wayAt(view.info, x + blockWidth / 2.0, y + blockHeight / 2.0, turn)};
      const int below = std::min(y + blockHeight, picture.height());
      for (int row = y; row < below && path.count > 1; ++row) {
        for (int i = 0; i < path.count; ++i) {
          const auto index = static_cast<std::size_t>(i);
          const int from = std::clamp(row + path.y[index], 0, picture.height() - 1);
          std::memcpy(samples[index].data(), sharpAt(x + path.x[index], from), sizeof(BlockRow));
        }
        bool up = true;
        for (auto left = static_cast<std::size_t>(path.count); left > 1; left /= 2, up = !up)
          for (std::size_t i = 0; i < left / 2; ++i) average(samples[i], samples[left - 1 - i], up);
        PackedColor* out = picture.row(row) + x;
        for (int k = 0; k < std::min(blockWidth, picture.width() - x); ++k) {
          PackedColor mean = 0;
          std::memcpy(&mean, &samples[0][static_cast<std::size_t>(channels * k)], channels);
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
