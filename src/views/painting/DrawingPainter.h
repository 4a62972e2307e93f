#pragma once
#include "debug/Drawing.h"

struct _cairo;

namespace gt {

/// Where a drawing's coordinates lie on a page: its origin in pixels, pixels for each of its units,
/// and whether its second axis goes up, as on the field, or down, as in pictures.
struct Placement {
  Vector2d origin = Vector2d::Zero();
  double scale = 1;
  bool up = false;

  Vector2d of(const Vector2d& point) const {
    return origin + scale * Vector2d{point.x(), up ? -point.y() : point.y()};
  }
};

/// Paints the elements of a drawing in the order in which they were drawn, with smooth edges (by
/// Cairo). The width of the pen counts in pixels of the page. What makes no sense (too few points,
/// not finite) is left out.
void paint(_cairo* context, const Drawing& drawing, const Placement& placement);

}  // namespace gt
