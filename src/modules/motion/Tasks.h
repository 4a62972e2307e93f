#pragma once
#include <tuple>

#include "representations/behavior/LedRequest.h"
#include "representations/infrastructure/Joints.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/WalkingEngineOutput.h"

/// The tasks of the motion (report 3.9), each an exchangeable slot. All of them run every 8 ms.
namespace gt {

struct WalkingEngine {
  using Outputs = std::tuple<WalkingEngineOutput>;
};
struct SpecialActions {
  using Outputs = std::tuple<SpecialActionsOutput>;
};
struct HeadControl {
  using Outputs = std::tuple<HeadMotionRequest>;
};
struct MotionControl {
  using Outputs = std::tuple<JointData, OdometryData, MotionInfo>;
};
struct LEDControl {
  using Outputs = std::tuple<LedValue>;
};

using MotionTasks =
    std::tuple<WalkingEngine, SpecialActions, HeadControl, MotionControl, LEDControl>;

}  // namespace gt
