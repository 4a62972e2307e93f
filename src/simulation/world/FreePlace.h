#pragma once
#include <optional>

#include "base/Geometry.h"

namespace gt {

/// The free place (mm) nearest to `asked`; `asked` itself if it is free. Searches rings around it
/// along 48 directions, each to a precision of `precise`, and leaves a gap to what is in the way if
/// there is room for it. Returns `asked` if there is no free place within `furthest`.
template <typename IsFree>
Vector2d nearestFree(const Vector2d& asked, const IsFree& isFree) {
  constexpr int directions = 48;
  constexpr double ring = 10, furthest = 4000, precise = 0.1, gap = 5;  // mm
  if (isFree(asked)) return asked;
  for (double outer = ring; outer <= furthest; outer += ring) {
    std::optional<Vector2d> way;  // of length 1
    double nearest = outer;
    for (int i = 0; i < directions; ++i) {
      const Vector2d along = direction(2 * pi * i / directions);
      if (!isFree(asked + nearest * along)) continue;
      double taken = outer - ring;
      while (nearest - taken > precise) {
        const double middle = (nearest + taken) / 2;
        (isFree(asked + middle * along) ? nearest : taken) = middle;
      }
      way = along;
    }
    if (!way) continue;
    const Vector2d withGap = asked + (nearest + gap) * *way;
    return isFree(withGap) ? withGap : asked + nearest * *way;
  }
  return asked;
}

}  // namespace gt
