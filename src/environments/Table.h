#pragma once
#include "environments/Environment.h"

namespace gt {

// The environments, one in each file.
EnvironmentDescription walkDescription();
EnvironmentDescription getUpDescription();
EnvironmentDescription kickDescription();
EnvironmentDescription approachDescription();
EnvironmentDescription penaltyDescription();
EnvironmentDescription goalieDescription();
EnvironmentDescription localizeDescription();
EnvironmentDescription soccerDescription();

}  // namespace gt
