#pragma once
#include "base/DataRoot.h"
#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// Plays for some seconds in real time with a team of four robots, each of which consists of three
/// programs, against a simulated one: whether the simulation keeps up, and how often a robot's
/// commands were not there in time: `speed.programs.*`. The programs lie beside this one; where
/// they were not built, that is reported and nothing measured.
Result<void> measureRobotPrograms(Figures& figures, const DataRoot& root);

}  // namespace gt
