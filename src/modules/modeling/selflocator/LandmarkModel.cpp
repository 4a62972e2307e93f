#include "modules/modeling/selflocator/LandmarkModel.h"

#include <algorithm>

namespace gt {

void LandmarkModel::observe(const Parameters& parameters, const Bearings& bearings,
                            const Vector2d& cameraOffset, ParticleSet& particles) {
  const std::size_t n = particles.size();
  sum_.resize(n);
  std::fill(sum_.begin(), sum_.end(), 0.f);
  const auto offsetX = static_cast<float>(cameraOffset.x());
  const auto offsetY = static_cast<float>(cameraOffset.y());
  const float* __restrict const x = particles.x.data();
  const float* __restrict const y = particles.y.data();
  const float* __restrict const c = particles.cosine.data();
  const float* __restrict const s = particles.sine.data();
  float* __restrict const sum = sum_.data();
  for (const Bearing& bearing : bearings) {
    const BearingTerms terms{bearing};
    for (std::size_t i = 0; i < n; ++i) {
      const float cameraX = x[i] + c[i] * offsetX - s[i] * offsetY;
      const float cameraY = y[i] + s[i] * offsetX + c[i] * offsetY;
      const float d = terms.deviation(cameraX, cameraY, c[i], s[i]);
      sum[i] += d * d;
    }
  }
  // The product (3.12) of exponentials is the exponential of a sum.
  const auto factor = static_cast<float>(-parameters.steepness / (pi * pi));
  const ProbabilityFilter filter{static_cast<float>(parameters.rise),
                                 static_cast<float>(parameters.fall)};
  float* __restrict const likelihood = particles.likelihood[Likelihood::landmarks].data();
  for (std::size_t i = 0; i < n; ++i)
    likelihood[i] = filter(likelihood[i], fastExp(factor * sum[i]));
}

}  // namespace gt
