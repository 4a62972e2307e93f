#include "framework/RepresentationDefinition.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/tactics/PlayValues.h"

namespace gt {

template const RepresentationType& representation<Behavior>();
template const RepresentationType& representation<PlayValues>();

}  // namespace gt
