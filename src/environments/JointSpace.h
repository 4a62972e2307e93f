#pragma once
#include <span>
#include <string>
#include <vector>

#include "environments/Space.h"
#include "representations/infrastructure/Joints.h"

/// Joints in the actions and observations of agents.
namespace gt {

/// All twelve joints of the legs.
std::vector<Joint> legJoints();
/// The joints of the head, then those of the legs.
std::vector<Joint> headAndLegJoints();

/// The angles (rad) of a robot that stands by the walking engine's default parameters.
JointAngles standingAngles();
/// The angles (rad) that actions request of some joints; all others are those of standing.
JointAngles anglesOf(std::span<const float> actions, std::span<const Joint> joints);

/// Adds what `anglesOf` reads to a space of actions.
void addJoints(Space& actions, std::span<const Joint> joints);
/// Adds a number for each joint, such as angle.legFR1, to a space of observations.
void addJoints(Space& observations, std::span<const Joint> joints, const std::string& what,
               const char* unit, double most);

}  // namespace gt
