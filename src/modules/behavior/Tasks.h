#pragma once
#include <tuple>

#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/SoundRequest.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {

/// Decision making (report 3.8).
struct BehaviorControl {
  using Outputs =
      std::tuple<MotionRequest, HeadControlMode, LedRequest, SoundRequest, BehaviorTeamMessage>;
};

/// Sensorimotor coupling: from the camera to motions in one module (report 2.2.1). In a layout it
/// replaces BehaviorControl, HeadControl and the modules that these need.
struct SensorBehaviorControl {
  using Outputs = std::tuple<MotionRequest, HeadMotionRequest, LedRequest, SoundRequest>;
};

using BehaviorTasks = std::tuple<BehaviorControl, SensorBehaviorControl>;

}  // namespace gt
