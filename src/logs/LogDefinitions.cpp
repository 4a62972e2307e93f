#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "framework/RepresentationDefinition.h"
#include "logs/RecordedSetup.h"
#include "logs/RobotLog.h"

namespace gt {

template const RepresentationType& representation<ImageHeader>();
template const RepresentationType& representation<HsiColors>();
template const RepresentationType& representation<TslColors>();
template const RepresentationType& representation<RecordedSetup>();
template const RepresentationType& representation<SetupRequest>();

}  // namespace gt
