#include "modules/motion/head/HeadPathPlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gt {
namespace {

constexpr double frameMs = 8;

double distance(const HeadAngles& a, const HeadAngles& b) {
  return std::hypot(a.tilt - b.tilt, a.pan - b.pan, a.roll - b.roll);
}

HeadAngles between(const HeadAngles& a, const HeadAngles& b, double share) {
  return {a.tilt + share * (b.tilt - a.tilt), a.pan + share * (b.pan - a.pan),
          a.roll + share * (b.roll - a.roll)};
}

}  // namespace

void HeadPathPlanner::plan(const HeadAngles& start, std::initializer_list<HeadAngles> points,
                           double duration) {
  assert(points.size() <= maxPoints);
  points_[0] = start;
  count_ = 1;
  length_ = way_ = 0;
  for (const auto& point : points) {
    length_ += distance(points_[static_cast<std::size_t>(count_ - 1)], point);
    points_[static_cast<std::size_t>(count_++)] = point;
  }
  perFrame_ = length_ * frameMs / std::max(duration, frameMs);
}

HeadAngles HeadPathPlanner::next() {
  way_ = std::min(way_ + perFrame_, length_);
  double left = way_;
  for (int i = 1; i < count_; ++i) {
    const auto& from = points_[static_cast<std::size_t>(i - 1)];
    const auto& to = points_[static_cast<std::size_t>(i)];
    const double piece = distance(from, to);
    if (left < piece) return between(from, to, left / piece);
    left -= piece;
  }
  return count_ > 0 ? points_[static_cast<std::size_t>(count_ - 1)] : HeadAngles{};
}

}  // namespace gt
