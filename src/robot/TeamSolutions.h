#pragma once
#include "robot/Configuration.h"

namespace gt {

/// In the folder that a team's robots read: the team's own modules.cfg, beside the project's. Each
/// line stands for the project's line of its task; all other tasks stay as the project has chosen
/// them.
constexpr const char* teamSolutions = "modules.team.cfg";

/// Lays a team's choices over the project's, each task once.
void layOver(std::vector<Configuration::SolutionChoice>& choices,
             const std::vector<Configuration::SolutionChoice>& team);

/// Whether a choice is the project's, below those of a team: it holds where the layout has its
/// task, since a team may play a layout with other tasks.
bool isInherited(const Configuration::SolutionChoice& choice,
                 const std::vector<Configuration::SolutionChoice>& choices);

}  // namespace gt
