#pragma once
#include <cstdint>
#include <string_view>

namespace gt {

/// A seeded random number generator (xoshiro256++, Blackman and Vigna 2019), the only source of
/// randomness. The same seed yields the same numbers on every machine.
class Random {
 public:
  using result_type = std::uint64_t;

  explicit Random(std::uint64_t seed = 0);

  /// Returns a separate generator for a part of the system. Its numbers do not depend on what other
  /// parts draw.
  Random fork(std::string_view name) const;

  result_type operator()();
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }

  /// Uniformly distributed in [0, 1).
  double uniform() { return static_cast<double>((*this)() >> 11) * 0x1.0p-53; }
  /// Uniformly distributed in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// The report's random(-1...1).
  double symmetric() { return uniform(-1, 1); }
  /// Normally distributed, mean 0, standard deviation 1.
  double gaussian();
  /// Uniformly distributed in 0 .. n-1; n must not be 0.
  std::uint64_t index(std::uint64_t n) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
  }
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t state_[4];
  double spare_ = 0;
  bool hasSpare_ = false;
};

}  // namespace gt
