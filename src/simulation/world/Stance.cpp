#include "simulation/world/Stance.h"

#include <algorithm>

namespace gt {
namespace {

using Points = std::array<GroundPoint, 5>;

const GroundPoint& lowest(const Points& points, double tilt) {
  const Stance stance{0, tilt};
  return *std::min_element(points.begin(), points.end(),
                           [&](const GroundPoint& a, const GroundPoint& b) {
                             return clearance(a, stance) < clearance(b, stance);
                           });
}

/// The tilt at which two points touch the ground together.
double tiltOf(const GroundPoint& fore, const GroundPoint& hind) {
  // (xf - xh) sin t + (zf - zh) cos t = rf - rh
  const double x = fore.position.x() - hind.position.x();
  const double z = fore.position.z() - hind.position.z();
  const double length = std::hypot(x, z);
  if (x <= 0 || length < 1) return 0;
  const double ratio = std::clamp((fore.radius - hind.radius) / length, -1., 1.);
  return std::asin(ratio) - std::atan2(z, x);
}

}  // namespace

Stance stand(const Points& fore, const Points& hind, double previousTilt) {
  constexpr double steepest = 1.2;
  constexpr int rounds = 4;  // which point is the lowest depends on the tilt, and changes little
  double tilt = previousTilt;
  for (int i = 0; i < rounds; ++i)
    tilt = std::clamp(tiltOf(lowest(fore, tilt), lowest(hind, tilt)), -steepest, steepest);
  const Stance flat{0, tilt};
  return {-std::min(clearance(lowest(fore, tilt), flat), clearance(lowest(hind, tilt), flat)),
          tilt};
}

}  // namespace gt
