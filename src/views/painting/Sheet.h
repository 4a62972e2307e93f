#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "representations/infrastructure/Image.h"
#include "views/painting/DrawingPainter.h"
#include "views/painting/SheetPainter.h"

namespace gt {

/// A camera image (YCbCr, full range as in JPEG) as RGB; missing pixels are black.
RgbImage rgbOf(const Image& image);

/// A page of images, drawings and text on which a view is painted. It can be written as PNG or SVG,
/// and painted repeatedly on any `SheetPainter`.
class Sheet {
 public:
  /// Width and height are in pixels, at most 4096.
  Sheet(int width, int height, Color background = colors::white);

  void paint(const Drawing& drawing, const Placement& placement = {});
  /// Paints an image with its upper left corner at a place (pixels). Each of its pixels becomes a
  /// square with sides of `scale` pixels.
  void paint(RgbImage picture, const Vector2d& at, double scale = 1);
  /// Paints a text (UTF-8) whose first letter's lower left corner lies at a place (pixels).
  void text(const Vector2d& at, const std::string& text, Color color = colors::black,
            double height = 12);
  void box(const Vector2d& corner, const Vector2d& size, Color color);
  void line(const Vector2d& from, const Vector2d& to, Color color, double penWidth = 1);

  int width() const { return width_; }
  int height() const { return height_; }
  void paintOn(SheetPainter& painter) const;
  /// The page in pixels.
  RgbImage pixels() const;
  /// The page as SVG.
  std::string svg() const;
  /// Writes the page by the file's extension, .png or .svg; creates its folder.
  Result<void> write(const std::string& file) const;

 private:
  int width_, height_;
  std::vector<std::function<void(SheetPainter&)>> strokes_;
};

/// A sheet with an image that is enlarged by a whole number.
Sheet pictureSheet(RgbImage picture, int scale);
inline Sheet imageSheet(const Image& image, int scale) {
  return pictureSheet(rgbOf(image), scale);
}

}  // namespace gt
