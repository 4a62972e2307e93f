#pragma once
#include "representations/infrastructure/Joints.h"

namespace gt {

/// Changes angles to the nearest that the motors can take: within their limits, and with the legs
/// beside the body.
void keepWithinLimits(JointAngles& angles);

}  // namespace gt
