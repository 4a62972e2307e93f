#pragma once
#include <cstdint>

namespace gt {

/// Increment of the counter that SplitMix64 mixes.
constexpr std::uint64_t splitMixStep = 0x9e3779b97f4a7c15;

/// Mixes a counter (SplitMix64; Steele, Lea and Flood 2014).
constexpr std::uint64_t splitMix(std::uint64_t x) {
  x += splitMixStep;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

}  // namespace gt
