#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "views/painting/DrawingPainter.h"
#include "representations/infrastructure/Image.h"

struct _cairo_surface;

namespace gt {

/// A picture of RGB, 3 bytes a pixel, row by row from the top.
struct RgbPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// A camera picture (YCbCr, full range as in JPEG) as RGB; pixels that it lacks are black.
RgbPicture rgbOf(const Image& image);

/// A page on which a view is painted, of pictures, drawings and text; written as PNG or SVG.
class Sheet {
 public:
  /// In pixels, at most 4096 a side.
  Sheet(int width, int height, Color background = colors::white);

  void paint(const Drawing& drawing, const Placement& placement = {});
  /// A picture with its upper left corner at a place; each of its pixels becomes a square.
  void paint(const RgbPicture& picture, const Vector2d& at, double scale = 1);
  /// A text whose first letter's lower left corner lies at a place.
  void text(const Vector2d& at, const std::string& text, Color color = colors::black,
            double height = 12);
  void box(const Vector2d& corner, const Vector2d& size, Color color);
  void line(const Vector2d& from, const Vector2d& to, Color color, double penWidth = 1);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The page in pixels.
  RgbPicture pixels() const;
  /// Writes the page by the file's extension, .png or .svg; makes its folder.
  Result<void> write(const std::string& file) const;

 private:
  void paintOn(_cairo_surface* surface) const;

  int width_, height_;
  /// What was painted, to be painted again in any resolution. Not Cairo's own recording: one that
  /// was written as SVG is never released (Cairo 1.16).
  std::vector<std::function<void(_cairo_surface*)>> strokes_;
};

}  // namespace gt
