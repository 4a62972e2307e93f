#pragma once
#include <span>
#include <string>
#include <vector>

#include "environments/Space.h"
#include "representations/infrastructure/Joints.h"

/// Joints as agents turn and observe them.
namespace gt {

/// All twelve joints of the legs.
std::vector<Joint> legJoints();
/// Those of the head, and of the legs.
std::vector<Joint> headAndLegJoints();

/// The angles of the legs by the walking engine's default, as it stands.
JointAngles standingAngles();
/// The angles that actions request of some joints; all others are as they stand.
JointAngles anglesOf(std::span<const float> actions, std::span<const Joint> joints);

/// Adds what `anglesOf` reads to a space of actions.
void addJoints(Space& actions, std::span<const Joint> joints);
/// Adds a number for each joint, such as angle.legFR1, to a space of observations.
void addJoints(Space& observations, std::span<const Joint> joints, const std::string& what,
               const char* unit, double most);

}  // namespace gt
