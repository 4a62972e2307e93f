#pragma once
#include <tuple>

#include "representations/behavior/LedRequest.h"
#include "representations/behavior/SoundRequest.h"
#include "representations/infrastructure/JointGains.h"
#include "representations/motion/GetupEngineOutput.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/perception/CollisionPercept.h"

/// The tasks of the motion (report 3.9). All of them run every 8 ms.
namespace gt {

constexpr double frameTime = 0.008;  ///< Time between two updates of a task of the motion, in s.

struct WalkingEngine {
  using Outputs = std::tuple<WalkingEngineOutput>;
};
struct SpecialActions {
  using Outputs = std::tuple<SpecialActionsOutput>;
};
/// Lets the robot stand up from any posture (report 3.9).
struct GetupEngine {
  using Outputs = std::tuple<GetupEngineOutput>;
};
struct HeadControl {
  using Outputs = std::tuple<HeadMotionRequest>;
};
struct MotionControl {
  using Outputs = std::tuple<JointData, JointGains, OdometryData, MotionInfo>;
};
/// Recognizes collisions (report 3.6).
struct CollisionDetector {
  using Outputs = std::tuple<CollisionPercept>;
};
struct LEDControl {
  using Outputs = std::tuple<LedValue>;
};

struct SoundControl {
  using Outputs = std::tuple<Speaker>;
};

using MotionTasks = std::tuple<WalkingEngine, SpecialActions, GetupEngine, HeadControl,
                               MotionControl, CollisionDetector, LEDControl, SoundControl>;

}  // namespace gt
