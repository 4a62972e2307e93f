#pragma once
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solution *Default* of TeamMessageSender: puts together what the robot reports to its teammates
/// (report 3.4.2).
class DefaultTeamMessageSender {
 public:
  /// Provides the message. A ball never seen is sent as such, an uncertain pose with its validity.
  void update(const RobotPose& robotPose, const BallModel& ball, const PlayersCollection& players,
              const BehaviorTeamMessage& behavior, const FrameInfo& frame, const Player& player,
              TeamMessage& message);
};

}  // namespace gt
