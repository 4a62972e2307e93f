#include "replay/Overlay.h"

#include <algorithm>
#include <cmath>

#include "streams/Jpeg.h"

namespace gt {
namespace {

std::uint8_t clamped(double value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
}

}  // namespace

Overlay::Overlay(const Image& image)
    : width_(image.info.width * scale),
      height_(image.info.height * scale),
      rgb_(static_cast<std::size_t>(3 * width_ * height_)) {
  std::size_t i = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const Pixel& p = image.at(x / scale, y / scale);
      const double cb = p.cb - 128.0, cr = p.cr - 128.0;
      rgb_[i++] = clamped(p.y + 1.402 * cr);
      rgb_[i++] = clamped(p.y - 0.344 * cb - 0.714 * cr);
      rgb_[i++] = clamped(p.y + 1.772 * cb);
    }
}

void Overlay::point(const Vector2d& p, Color color) {
  const double x = p.x() * scale, y = p.y() * scale;
  if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return;
  const std::size_t i =
      3 * static_cast<std::size_t>(static_cast<int>(y) * width_ + static_cast<int>(x));
  rgb_[i] = color.r;
  rgb_[i + 1] = color.g;
  rgb_[i + 2] = color.b;
}

void Overlay::line(const Vector2d& from, const Vector2d& to, Color color) {
  const double length = (to - from).norm() * scale;
  if (!(length < 1e5)) return;
  const int n = static_cast<int>(length) + 1;
  for (int i = 0; i <= n; ++i) point(from + (to - from) * (static_cast<double>(i) / n), color);
}

void Overlay::circle(const Vector2d& center, double radius, Color color) {
  const int n = 8 + static_cast<int>(std::min(radius, 1e4) * 2 * pi * scale);
  for (int i = 0; i < n; ++i) point(center + direction(2 * pi * i / n) * radius, color);
}

void Overlay::draw(const Drawing& drawing) {
  for (const auto& shape : drawing.elements) {
    const auto& p = shape.points;
    if (shape.type == ElementType::circle || shape.type == ElementType::point)
      circle(p.front(), shape.size, shape.color);
    for (std::size_t i = 1; i < p.size(); ++i) line(p[i - 1], p[i], shape.color);
    if (shape.type == ElementType::polygon) line(p.back(), p.front(), shape.color);
  }
}

Result<void> Overlay::write(const std::string& file) const {
  return writePng(file, width_, height_, rgb_);
}

}  // namespace gt
