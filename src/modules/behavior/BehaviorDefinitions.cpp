#include "framework/RepresentationDefinition.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/control/BehaviorControlRequest.h"
#include "modules/behavior/control/BehaviorRequest.h"
#include "modules/behavior/potentialfields/PotentialFields.h"
#include "modules/behavior/tactics/PlayValues.h"
#include "modules/behavior/tactics/TargetPoints.h"

namespace gt {

template const RepresentationType& representation<Behavior>();
template const RepresentationType& representation<BehaviorControlRequest>();
template const RepresentationType& representation<BehaviorRequest>();
template const RepresentationType& representation<PlayValues>();
template const RepresentationType& representation<PotentialFields>();
template const RepresentationType& representation<TargetPoints>();

}  // namespace gt
