#pragma once
#include <QImage>
#include <QPainter>

#include "views/painting/SheetPainter.h"

namespace gt {

/// Paints a sheet by Qt, in windows at any size.
class QtPainter : public SheetPainter {
 public:
  explicit QtPainter(QPainter& painter) : painter_{painter} {}

  void line(std::span<const Vector2d> points, bool closed, const Pen& pen) override;
  void area(std::span<const Vector2d> corners, Color color) override;
  void circle(const Vector2d& center, double radius, const Pen& pen) override;
  void disk(const Vector2d& center, double radius, Color color) override;
  void sector(const Vector2d& center, double radius, double from, double to, Color color) override;
  void text(const Vector2d& at, std::string_view text, const Font& font) override;
  void picture(const RgbImage& picture, const Vector2d& at, double scale) override;

 private:
  QPainter& painter_;
};

inline QColor qColor(const Color& color) {
  return {color.r, color.g, color.b, color.a};
}

/// Wraps an image without a copy; `picture` must outlive the result.
inline QImage wrapped(const RgbImage& picture) {
  return {picture.pixels.data(), picture.width, picture.height, 3 * picture.width,
          QImage::Format_RGB888};
}

}  // namespace gt
