#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

#include "streams/Reflection.h"

namespace gt {

/// Measures the duration of a repeated piece of work by the machine's own clock (report E.7). For
/// people and benchmarks only: nothing that a robot does may depend on it.
struct Stopwatch {
  std::string name;
  std::int64_t count = 0;
  double totalMs = 0;
  double lastMs = 0;
  double longestMs = 0;

  double meanMs() const { return count == 0 ? 0 : totalMs / static_cast<double>(count); }

  /// Measures the time from its construction to its destruction.
  class Lap {
   public:
    explicit Lap(Stopwatch& watch) : watch_{watch}, begin_{Clock::now()} {}
    ~Lap() {
      watch_.lastMs = std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
      watch_.totalMs += watch_.lastMs;
      watch_.longestMs = std::max(watch_.longestMs, watch_.lastMs);
      ++watch_.count;
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    using Clock = std::chrono::steady_clock;

    Stopwatch& watch_;
    Clock::time_point begin_;
  };

  static constexpr auto fields() {
    return Fields{field<&Stopwatch::name>("name of the task or piece of work"),
                  field<&Stopwatch::count>("number of executions"),
                  field<&Stopwatch::totalMs>(Unit::ms), field<&Stopwatch::lastMs>(Unit::ms),
                  field<&Stopwatch::longestMs>(Unit::ms)};
  }
};

}  // namespace gt
