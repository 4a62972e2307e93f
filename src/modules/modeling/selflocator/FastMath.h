#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gt {

/// atan2 by a polynomial, with errors up to 2e-5 rad, which suffices for comparisons with measured
/// angles. Without branches, so that loops over particles are vectorized. Returns 0 for (0, 0).
inline float fastAtan2(float y, float x) {
  constexpr float straight = std::numbers::pi_v<float>;
  const float ax = std::abs(x), ay = std::abs(y);
  const float larger = ax > ay ? ax : ay, smaller = ax > ay ? ay : ax;
  const float z = smaller / (larger > 1e-30f ? larger : 1e-30f), z2 = z * z;
  float a = z * (0.9998660f +
                 z2 * (-0.3302995f + z2 * (0.1801410f + z2 * (-0.0851330f + z2 * 0.0208351f))));
  a = ay > ax ? straight / 2 - a : a;
  a = x < 0 ? straight - a : a;
  return y < 0 ? -a : a;
}

/// exp by a polynomial for numbers that are not positive, with a relative error up to 1e-5. Numbers
/// below -80 are replaced by -80.
inline float fastExp(float x) {
  const float t = (x > -80.f ? x : -80.f) * std::numbers::log2e_v<float>;
  const auto whole = static_cast<std::int32_t>(t - 0.5f);
  const float f = t - static_cast<float>(whole);  // in [-0.5, 0.5]
  const float power =
      1 + f * (0.69314718f +
               f * (0.24022651f + f * (0.05550411f + f * (0.00961813f + f * 0.00133336f))));
  return power * std::bit_cast<float>((whole + 127) << 23);
}

}  // namespace gt
