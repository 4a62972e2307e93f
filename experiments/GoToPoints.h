#pragma once
#include <cstdint>
#include <vector>

#include "measure/worlds/SimulatedWalker.h"
#include "modules/modeling/testing/Locators.h"

namespace gt {

/// How far a robot stands off when it has walked to a point, and how far its estimate is off then
/// (mm).
struct Arrival {
  double ofRobot, ofEstimate;
};

/// Has a robot go to random points one after another, by the behavior's own skill, with the head
/// always turning (report 3.3.3.4, experiment 2).
std::vector<Arrival> goToPoints(SimulatedWalker& robot, AnyLocator& locator, int points,
                                std::uint64_t seed);

}  // namespace gt
