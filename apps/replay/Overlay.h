#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Result.h"
#include "debug/Drawing.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// A picture in RGB, enlarged, on which percepts are drawn.
class Overlay {
 public:
  explicit Overlay(const Image& image);

  /// Draws the shapes of a debug drawing in the picture's coordinates.
  void draw(const Drawing& drawing);
  void line(const Vector2d& from, const Vector2d& to, Color color);
  void circle(const Vector2d& center, double radius, Color color);
  /// As PNG.
  Result<void> write(const std::string& file) const;

 private:
  static constexpr int scale = 2;

  void point(const Vector2d& p, Color color);

  int width_, height_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace gt
