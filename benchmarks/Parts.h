#pragma once
#include <benchmark/benchmark.h>

#include "experiments/Figures.h"

namespace gt {

/// How often a part is measured, each time for a tenth of a second, and how it is told.
inline void inMicroseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kMicrosecond);
}
inline void inNanoseconds(benchmark::internal::Benchmark* part) {
  part->Repetitions(5)->MinTime(0.1)->Unit(benchmark::kNanosecond);
}

/// Measures all parts that are registered by BENCHMARK(), in time of the processor.
void measureParts(Figures& figures);

}  // namespace gt
