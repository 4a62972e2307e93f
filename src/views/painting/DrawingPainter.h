#pragma once
#include "debug/Drawing.h"
#include "views/painting/SheetPainter.h"

namespace gt {

/// Where a drawing's coordinates lie on a sheet: its origin in pixels, pixels for each of its
/// units, and whether its second axis goes up, as on the field, or down, as in images.
struct Placement {
  Vector2d origin = Vector2d::Zero();
  double scale = 1;
  bool up = false;

  Vector2d of(const Vector2d& point) const {
    return origin + scale * Vector2d{point.x(), up ? -point.y() : point.y()};
  }
};

/// Paints an element of a drawing. The width of the pen counts in pixels of the sheet. What makes
/// no sense (too few points, not finite) is left out.
void paint(SheetPainter& painter, const DrawingElement& element, const Placement& placement);

}  // namespace gt
