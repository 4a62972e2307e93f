#include "framework/RepresentationDefinition.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/tactics/PlayValues.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/PotentialFields.h"
#include "representations/behavior/TargetPoints.h"

namespace gt {

template const RepresentationType& representation<Behavior>();
template const RepresentationType& representation<BehaviorControlRequest>();
template const RepresentationType& representation<BehaviorRequest>();
template const RepresentationType& representation<PlayValues>();
template const RepresentationType& representation<PotentialFields>();
template const RepresentationType& representation<TargetPoints>();

}  // namespace gt
