#pragma once
#include "debug/Drawing.h"
#include "views/painting/SheetPainter.h"

namespace gt {

/// Maps a drawing's coordinates to a sheet: the drawing's origin in pixels, the pixels for each of
/// its units, and whether its second axis points up, as on the field, or down, as in images.
struct Placement {
  Vector2d origin = Vector2d::Zero();
  double scale = 1;
  bool up = false;

  Vector2d of(const Vector2d& point) const {
    return origin + scale * Vector2d{point.x(), up ? -point.y() : point.y()};
  }
};

/// Paints an element of a drawing. The width of the pen is in pixels of the sheet. Invalid elements
/// (too few points, not finite) are left out.
void paint(SheetPainter& painter, const DrawingElement& element, const Placement& placement);

}  // namespace gt
