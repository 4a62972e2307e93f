#include "simulation/world/Carpet.h"

#include <cmath>

#include "base/SplitMix.h"

namespace gt {

Vector2d Carpet::pullAt(std::int64_t x, std::int64_t y) const {
  const std::uint64_t chance = splitMix(splitMix(splitMix(seed_) + static_cast<std::uint64_t>(x)) +
                                        static_cast<std::uint64_t>(y));
  const auto symmetric = [](std::uint64_t bits) {
    return static_cast<double>(bits & 0xffffffff) / 0x80000000 - 1;
  };
  return {symmetric(chance), symmetric(chance >> 32)};
}

Vector2d Carpet::pull(const Vector2d& place) const {
  const Vector2d at = place / dentSize_;
  const Vector2d corner{std::floor(at.x()), std::floor(at.y())};
  const auto x = static_cast<std::int64_t>(corner.x()), y = static_cast<std::int64_t>(corner.y());
  const Vector2d share = at - corner;
  const Vector2d near = (1 - share.x()) * pullAt(x, y) + share.x() * pullAt(x + 1, y);
  const Vector2d far = (1 - share.x()) * pullAt(x, y + 1) + share.x() * pullAt(x + 1, y + 1);
  return (1 - share.y()) * near + share.y() * far;
}

}  // namespace gt
