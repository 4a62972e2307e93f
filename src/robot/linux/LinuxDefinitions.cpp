#include "framework/RepresentationDefinition.h"
#include "robot/linux/Lockstep.h"

namespace gt {

template const RepresentationType& representation<LockstepGreeting>();
template const RepresentationType& representation<LockstepFailure>();

}  // namespace gt
