#pragma once
#include <benchmark/benchmark.h>

#include <string>

#include "experiments/Figures.h"

namespace gt {

/// How often a part is measured, each time for a tenth of a second, and how it is told.
inline void inMilliseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMillisecond);
}
inline void inMicroseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMicrosecond);
}
inline void inNanoseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kNanosecond);
}

/// What a part's time should be at most, in the unit in which it is told.
inline void aim(benchmark::State& state, double atMost) {
  state.counters["aim"] = atMost;
}

/// Measures the parts that are registered by BENCHMARK() and whose names match a regular
/// expression, in time of the processor if they do not ask for real time.
void measureParts(Figures& figures, const std::string& only);

}  // namespace gt
