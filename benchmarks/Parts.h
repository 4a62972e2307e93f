#pragma once
#include <benchmark/benchmark.h>

#include <string>

#include "base/DataRoot.h"
#include "measure/Figures.h"

namespace gt {

/// How often a part is measured, each time for a tenth of a second, and how it is reported.
inline void inMilliseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMillisecond);
}
inline void inMicroseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMicrosecond);
}
inline void inNanoseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kNanosecond);
}

/// What a part's time should be at most, in the unit in which it is reported.
inline void aim(benchmark::State& state, double atMost) {
  state.counters["aim"] = atMost;
}

/// Where the parts find their data.
const DataRoot& dataRoot();

/// Measures the parts that are registered by BENCHMARK() and whose names match a regular
/// expression, in time of the processor if they do not ask for real time. Returns how many match.
std::size_t measureParts(Figures& figures, const std::string& only, const DataRoot& root);

}  // namespace gt
