#include "modules/perception/specialists/EdgeAngles.h"

#include <cmath>

namespace gt {

void EdgeAngles::add(double angle, bool onBorder) {
  if (count_ < scans_.size()) scans_[count_++] = {angle, onBorder};
}

EdgeAngles::Merged EdgeAngles::merge(double sign, double tolerance, double share) const {
  if (count_ == 0) return {};
  double extreme = scans_[0].angle;
  for (std::size_t i = 1; i < count_; ++i)
    if (sign * scans_[i].angle > sign * extreme) extreme = scans_[i].angle;
  double sum = 0;
  int met = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (scans_[i].onBorder || std::abs(scans_[i].angle - extreme) > tolerance) continue;
    sum += scans_[i].angle;
    ++met;
  }
  if (met == 0 || met < share * static_cast<double>(count_)) return {extreme, true};
  return {sum / met, false};
}

}  // namespace gt
