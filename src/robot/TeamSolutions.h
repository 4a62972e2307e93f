#pragma once
#include "robot/Configuration.h"

namespace gt {

/// Name of the team's own modules.cfg in the folder that its robots read. Each of its lines
/// replaces the project's line for the same task; all other tasks keep the project's solutions.
constexpr const char* teamSolutions = "modules.team.cfg";

/// Replaces the project's choices by those of a team, for each task that the team lists.
void layOver(std::vector<Configuration::SolutionChoice>& choices,
             const std::vector<Configuration::SolutionChoice>& team);

/// Whether a choice comes from the project while there are also choices of a team. Such a choice is
/// ignored if the layout lacks its task, since a team may use a layout with other tasks.
bool isInherited(const Configuration::SolutionChoice& choice,
                 const std::vector<Configuration::SolutionChoice>& choices);

}  // namespace gt
