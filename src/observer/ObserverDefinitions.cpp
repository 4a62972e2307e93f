#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "framework/RepresentationDefinition.h"
#include "observer/RecordedSetup.h"
#include "observer/RobotLog.h"

namespace gt {

template const RepresentationType& representation<ImageHeader>();
template const RepresentationType& representation<HsiColors>();
template const RepresentationType& representation<TslColors>();
template const RepresentationType& representation<RecordedSetup>();
template const RepresentationType& representation<SetupRequest>();

}  // namespace gt
