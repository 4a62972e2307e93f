#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "debug/Drawing.h"

namespace gt {

/// An image of RGB, 3 bytes a pixel, row by row from the top.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

/// A target on which a sheet is painted: an image, a file, a window. Coordinates are pixels from
/// the upper left corner, to the right and down; angles (rad) are counted from the right, clockwise
/// on the sheet.
class SheetPainter {
 public:
  /// The style of lines, whose ends and corners are round.
  struct Pen {
    Color color;
    double width = 1;
    PenStyle style = PenStyle::solid;
  };
  /// The style of a text.
  struct Font {
    Color color;
    double height = 12;
    bool bold = false;
    /// Whether it has a dark or bright outline, so that it can be read on any image.
    bool seam = false;
  };

  virtual ~SheetPainter() = default;
  virtual void line(std::span<const Vector2d> points, bool closed, const Pen& pen) = 0;
  virtual void area(std::span<const Vector2d> corners, Color color) = 0;
  virtual void circle(const Vector2d& center, double radius, const Pen& pen) = 0;
  virtual void disk(const Vector2d& center, double radius, Color color) = 0;
  /// A sector of a disk, clockwise from one angle to another.
  virtual void sector(const Vector2d& center, double radius, double from, double to,
                      Color color) = 0;
  /// A text (UTF-8) whose first letter's lower left corner lies at a place.
  virtual void text(const Vector2d& at, std::string_view text, const Font& font) = 0;
  /// An image with its upper left corner at a place; each of its pixels becomes a square.
  virtual void picture(const RgbImage& picture, const Vector2d& at, double scale) = 0;
};

}  // namespace gt
