#pragma once
#include <compare>
#include <cstdint>

namespace gt {

/// A point in time in ms since the robot's start, by the platform's clock.
struct Time {
  std::int64_t ms = 0;

  friend constexpr auto operator<=>(Time, Time) = default;
  friend constexpr std::int64_t operator-(Time a, Time b) { return a.ms - b.ms; }
  friend constexpr Time operator+(Time t, std::int64_t d) { return {t.ms + d}; }
  friend constexpr Time operator-(Time t, std::int64_t d) { return {t.ms - d}; }
};

/// Sentinel for "never": one hour before the start, which is too long ago for every test of age.
constexpr Time never() {
  return {-3'600'000};
}

}  // namespace gt
