#pragma once
#include <string>
#include <vector>

#include "simulation/Simulation.h"

namespace gt {

/// Describes how a placement by hand differs from the request: one line for the place, one for the
/// speed. Empty if it does not differ.
std::vector<std::string> describe(const Simulation& simulation, const Put& put);
/// Describes all placements since the last tick, as `describe` does.
std::vector<std::string> describePuts(const Simulation& simulation);

}  // namespace gt
