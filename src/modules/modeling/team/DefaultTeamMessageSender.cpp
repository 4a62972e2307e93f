#include "modules/modeling/team/DefaultTeamMessageSender.h"

namespace gt {

void DefaultTeamMessageSender::update(const RobotPose& robotPose, const BallModel& ball,
                                      const BehaviorTeamMessage& behavior, const FrameInfo& frame,
                                      const Player& player, TeamMessage& message) {
  message.playerNumber = player.number();
  message.timeSent = frame.time;
  message.robotPose = robotPose.pose;
  message.robotPoseValidity = robotPose.validity;
  message.ballPosition = robotPose.pose * ball.position;
  message.ballSpeed = rotated(ball.speed, robotPose.pose.rotation);
  message.ballStandardDeviation = ball.standardDeviation;
  message.ballLastSeen = ball.lastSeen;
  message.behavior = behavior;
}

}  // namespace gt
