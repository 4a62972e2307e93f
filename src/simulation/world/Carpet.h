#pragma once
#include <cstdint>

#include "base/Geometry.h"

namespace gt {

/// A carpet that is nowhere quite even (report 4.1.3): where it pulls a ball, as a share of its
/// strongest pull. The same seed is the same carpet.
class Carpet {
 public:
  Carpet(std::uint64_t seed, double dentSize) : seed_{seed}, dentSize_{dentSize} {}

  /// Both coordinates are in -1 to 1, 0 on average, and change smoothly over a dent's size.
  Vector2d pull(const Vector2d& place) const;

 private:
  Vector2d pullAt(std::int64_t x, std::int64_t y) const;

  std::uint64_t seed_;
  double dentSize_;
};

}  // namespace gt
