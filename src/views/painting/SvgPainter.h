#pragma once
#include <string>

#include "views/painting/SheetPainter.h"

namespace gt {

/// Writes a sheet as SVG. Text stays text, and is shown in the viewer's sans-serif font.
class SvgPainter : public SheetPainter {
 public:
  SvgPainter(int width, int height);

  void line(std::span<const Vector2d> points, bool closed, const Pen& pen) override;
  void area(std::span<const Vector2d> corners, Color color) override;
  void circle(const Vector2d& center, double radius, const Pen& pen) override;
  void disk(const Vector2d& center, double radius, Color color) override;
  void sector(const Vector2d& center, double radius, double from, double to, Color color) override;
  void text(const Vector2d& at, std::string_view text, const Font& font) override;
  void picture(const RgbImage& picture, const Vector2d& at, double scale) override;

  /// The content of the whole file.
  std::string svg() const { return svg_ + "</svg>\n"; }

 private:
  std::string svg_;
};

}  // namespace gt
