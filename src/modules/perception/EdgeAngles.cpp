#include "modules/perception/EdgeAngles.h"

#include <algorithm>

namespace gt {

void EdgeAngles::add(double angle, bool onBorder) {
  auto& angles = onBorder ? borderAngles_ : insideAngles_;
  std::size_t& count = onBorder ? border_ : inside_;
  if (count < capacity) angles[count++] = angle;
}

EdgeAngles::Merged EdgeAngles::merge(double sign, double tolerance) const {
  const bool onBorder = inside_ == 0;
  const auto& angles = onBorder ? borderAngles_ : insideAngles_;
  const std::size_t count = onBorder ? border_ : inside_;
  if (count == 0) return {};
  double extreme = angles[0];
  for (std::size_t i = 1; i < count; ++i)
    if (sign * angles[i] > sign * extreme) extreme = angles[i];
  double sum = 0;
  int close = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (std::abs(angles[i] - extreme) <= tolerance) {
      sum += angles[i];
      ++close;
    }
  return {onBorder ? extreme : sum / close, onBorder};
}

}  // namespace gt
