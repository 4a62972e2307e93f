#pragma once
#include "base/DataRoot.h"
#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// What of matches is measured.
struct MatchSpeedOptions {
  DataRoot root;
  double minutes = 1;  ///< Of each match.
  int runs = 3;        ///< Each on a seed of its own.
};

/// Plays whole matches 4:4 with all cameras, on one and on two threads, with and without logs, in
/// both fidelities, and without images on oracled world states: how many times faster than real
/// time; how long each module and each part of the simulator takes for a call, and in a simulated
/// second; and how it grows from 1 to 22 robots. Fails if a scene does not load.
Result<void> measureMatchSpeed(Figures& figures, const MatchSpeedOptions& options);

}  // namespace gt
