#pragma once
#include <cstdint>
#include <vector>

#include "Figures.h"

namespace gt {

/// What all experiments are asked for.
struct ExperimentOptions {
  std::vector<std::uint64_t> seeds;
  double minutes = 10;  ///< Of a match.
};

/// Whole matches: goals, own goals, localization against the truth.
void measureMatches(Figures& figures, const ExperimentOptions& options);
/// The Monte-Carlo self-locator on its test bench (report 3.3.2.5, 3.3.3.4).
void measureLocalization(Figures& figures, const ExperimentOptions& options);
/// The image processor on random views of the simulated field.
void measureVision(Figures& figures, const ExperimentOptions& options);

}  // namespace gt
