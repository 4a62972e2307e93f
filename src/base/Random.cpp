#include "base/Random.h"

#include <bit>
#include <cmath>

#include "base/Hash.h"
#include "base/SplitMix.h"

namespace gt {

Random::Random(std::uint64_t seed) {
  // As the authors of xoshiro recommend.
  for (auto& word : state_) {
    word = splitMix(seed);
    seed += splitMixStep;
  }
}

Random Random::fork(std::string_view name) const {
  Fingerprint hash;
  hash.add(name);
  return Random{hash.value() ^ std::rotl(state_[0], 17) ^ state_[2]};
}

Random::result_type Random::operator()() {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::gaussian() {
  if (hasSpare_) {
    hasSpare_ = false;
    return spare_;
  }
  double u, v, s;
  do {  // Marsaglia's polar method
    u = symmetric();
    v = symmetric();
    s = u * u + v * v;
  } while (s >= 1 || s == 0);
  const double factor = std::sqrt(-2 * std::log(s) / s);
  spare_ = v * factor;
  hasSpare_ = true;
  return u * factor;
}

}  // namespace gt
