#pragma once

#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

/// The largest Model::largestActivation and the longest path of options that are accepted.
constexpr std::size_t maximalActivation = 100'000;
constexpr int maximalPath = 200;

/// Checks that options form a directed graph without cycles (report 3.8.1.1). Also limits the
/// number of options executed in one cycle of the engine, which multiplies if options call others
/// several times.
void checkOptionGraph(Model& model, Reporter& reporter);

}  // namespace xabsl
