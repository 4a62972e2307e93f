#pragma once
#include "environments/Environment.h"

namespace gt {

// The descriptions of the environments, each in a file of its own.
EnvironmentDescription walkDescription();
EnvironmentDescription getUpDescription();
EnvironmentDescription kickDescription();
EnvironmentDescription approachDescription();
EnvironmentDescription penaltyDescription();
EnvironmentDescription goalieDescription();
EnvironmentDescription localizeDescription();
EnvironmentDescription soccerDescription();

}  // namespace gt
