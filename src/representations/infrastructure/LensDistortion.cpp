#include "representations/infrastructure/LensDistortion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gt {

// The first positive x = r^2 with 1 + 3 k2 x + 5 k4 x^2 = 0, the slope of the distorted distance.
double LensDistortion::limit() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (k4 == 0) return k2 < 0 ? -1 / (3 * k2) : infinite;
  const double root = 9 * k2 * k2 - 20 * k4;
  if (root < 0) return infinite;
  double first = infinite;
  for (const double sign : {-1.0, 1.0}) {
    const double x = (-3 * k2 + sign * std::sqrt(root)) / (10 * k4);
    if (x > 0) first = std::min(first, x);
  }
  return first;
}

double LensDistortion::factor(double square) const {
  const double x = std::min(square, limit());
  return 1 + x * (k2 + x * k4);
}

double LensDistortion::undoing(double square) const {
  const double seen = std::sqrt(square), edge = limit();
  if (seen == 0) return 1;
  const double evenFrom = std::sqrt(edge);
  if (std::isfinite(edge) && seen >= evenFrom * factor(edge)) return 1 / factor(edge);
  // Newton's method; within the limit the distorted distance grows with the true one.
  double r = std::min(seen, evenFrom);
  for (int i = 0; i < 60; ++i) {
    const double x = r * r, slope = 1 + x * (3 * k2 + 5 * x * k4);
    const double step = (r * factor(x) - seen) / std::max(slope, 0.01);
    r = std::clamp(r - step, 0.0, evenFrom);
    if (std::abs(step) < 1e-12) break;
  }
  return r / seen;
}

}  // namespace gt
