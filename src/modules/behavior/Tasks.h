#pragma once
#include <tuple>

#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/SoundRequest.h"
#include "representations/behavior/TeamMessage.h"

namespace gt {

/// Decision making (report 3.8).
struct BehaviorControl {
  using Outputs =
      std::tuple<MotionRequest, HeadControlMode, LedRequest, SoundRequest, BehaviorTeamMessage>;
};

using BehaviorTasks = std::tuple<BehaviorControl>;

}  // namespace gt
