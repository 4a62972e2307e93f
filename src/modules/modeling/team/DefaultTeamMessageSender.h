#pragma once
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Puts together what the robot tells its team mates (report 3.4.2). A solution of
/// TeamMessageSender.
class DefaultTeamMessageSender {
 public:
  /// Provides the message. A ball never seen is sent as such; how sure the pose is is sent beside
  /// it.
  void update(const RobotPose& robotPose, const BallModel& ball,
              const BehaviorTeamMessage& behavior, const FrameInfo& frame, const Player& player,
              TeamMessage& message);
};

}  // namespace gt
