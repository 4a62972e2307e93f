#include "simulation/world/StepNoise.h"

#include <cmath>

#include "simulation/world/World.h"

namespace gt {

Pose2D StepNoise::next(const NoiseParameters& noise, const Pose2D& step) {
  const double length = step.translation.norm();
  if (noise.motion == 0 || (length == 0 && step.rotation == 0)) return {};
  constexpr double stepTime = 0.25;  // s
  static const double keep = std::exp(-tickSeconds / stepTime);
  static const double fresh = std::sqrt(1 - keep * keep);
  // Sums over many ticks have the standard deviation of white noise: it grows with the square root
  // of the distance.
  static const double white = std::sqrt((1 - keep) / (1 + keep));
  for (double& now : now_) now = keep * now + fresh * random_.gaussian();
  const double root = std::sqrt(length / 1000);
  const double way = noise.motion * white * 20 * root;
  const double turn =
      noise.motion * white *
      (fromDegrees(1) * root + fromDegrees(5) * std::sqrt(std::abs(step.rotation) / (2 * pi)));
  return {turn * now_[2], way * now_[0], way * now_[1]};
}

}  // namespace gt
