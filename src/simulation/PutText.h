#pragma once
#include <string>
#include <vector>

#include "simulation/Simulation.h"

namespace gt {

/// What is different from what was asked for where something was put by hand, a line for a place
/// and one for a speed; empty if it was put as asked.
std::vector<std::string> describe(const Simulation& simulation, const Put& put);
/// The same for all that was put since the last tick.
std::vector<std::string> describePuts(const Simulation& simulation);

}  // namespace gt
