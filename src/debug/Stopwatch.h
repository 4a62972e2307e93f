#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace gt {

/// Measures how long a piece of work takes by the machine's own clock, over many times (report
/// E.7). For people and benchmarks only: nothing that a robot does may depend on it.
class Stopwatch {
 public:
  explicit Stopwatch(std::string name) : name_{std::move(name)} {}

  /// Measures from its construction to its destruction.
  class Lap {
   public:
    explicit Lap(Stopwatch& watch) : watch_{watch}, begin_{Clock::now()} {}
    ~Lap() {
      watch_.total_ += Clock::now() - begin_;
      ++watch_.count_;
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Stopwatch& watch_;
    std::chrono::steady_clock::time_point begin_;
  };

  const std::string& name() const { return name_; }
  std::int64_t count() const { return count_; }
  double totalMs() const { return std::chrono::duration<double, std::milli>(total_).count(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::string name_;
  std::int64_t count_ = 0;
  Clock::duration total_{};
};

}  // namespace gt
