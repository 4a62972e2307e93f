#pragma once
#include <cstdint>

#include "base/Geometry.h"

namespace gt {

/// An uneven carpet (report 4.1.3), which pulls a ball into its dents. The same seed gives the same
/// carpet. `dentSize` is the distance from one dent to the next (mm).
class Carpet {
 public:
  Carpet(std::uint64_t seed, double dentSize) : seed_{seed}, dentSize_{dentSize} {}

  /// The pull at a place on the field (mm), as a share of the strongest pull. Both coordinates are
  /// in -1 to 1, 0 on average, and change smoothly over a dent's size.
  Vector2d pull(const Vector2d& place) const;

 private:
  Vector2d pullAt(std::int64_t x, std::int64_t y) const;

  std::uint64_t seed_;
  double dentSize_;
};

}  // namespace gt
