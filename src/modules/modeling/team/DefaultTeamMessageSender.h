#pragma once
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solution *Default* of TeamMessageSender: composes the robot's message to its teammates (report
/// 3.4.2).
class DefaultTeamMessageSender {
 public:
  /// Provides the message. A ball never seen is sent as never seen, an uncertain pose with its
  /// validity.
  void update(const RobotPose& robotPose, const BallModel& ball, const PlayersCollection& players,
              const BehaviorTeamMessage& behavior, const FrameInfo& frame, const Player& player,
              TeamMessage& message);
};

}  // namespace gt
