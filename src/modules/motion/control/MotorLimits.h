#pragma once
#include "representations/infrastructure/Joints.h"

namespace gt {

/// Changes angles to the nearest ones that the motors can reach: within their limits, and without
/// legs that touch the body.
void keepWithinLimits(JointAngles& angles);

}  // namespace gt
