#include "modules/perception/specialists/EdgeAngles.h"

#include <cmath>
#include <span>

namespace gt {

void EdgeAngles::add(double angle, bool onBorder) {
  if (count_ < scans_.size()) scans_[count_++] = {angle, onBorder};
}

// The outermost of all scans, or of those that met the edge; null if there is none.
const EdgeAngles::Scan* EdgeAngles::outermost(double sign, bool met) const {
  const Scan* farthest = nullptr;
  for (const Scan& scan : std::span{scans_}.first(count_))
    if ((!met || !scan.onBorder) && (!farthest || sign * scan.angle > sign * farthest->angle))
      farthest = &scan;
  return farthest;
}

EdgeAngles::Merged EdgeAngles::merge(double sign, double tolerance, double share) const {
  if (count_ == 0) return {};
  double sum = 0;
  int met = 0;
  if (const Scan* edge = outermost(sign, share > 0))
    for (const Scan& scan : std::span{scans_}.first(count_)) {
      if (scan.onBorder || std::abs(scan.angle - edge->angle) > tolerance) continue;
      sum += scan.angle;
      ++met;
    }
  if (met == 0 || met < share * static_cast<double>(count_))
    return {outermost(sign, false)->angle, true};
  return {sum / met, false};
}

}  // namespace gt
