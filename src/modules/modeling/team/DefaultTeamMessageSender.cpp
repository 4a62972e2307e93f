#include "modules/modeling/team/DefaultTeamMessageSender.h"

#include <algorithm>

namespace gt {

void DefaultTeamMessageSender::update(const RobotPose& robotPose, const BallModel& ball,
                                      const PlayersCollection& players,
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
  message.opponents.fill({});
  const std::size_t count = std::min(players.seenOpponents.size(), message.opponents.size());
  for (std::size_t i = 0; i < count; ++i) {
    const LocatedPlayer& seen = players.seenOpponents[i];
    message.opponents[i] = {seen.position, seen.lastSeen, seen.validity, seen.standardDeviation};
  }
  message.behavior = behavior;
}

}  // namespace gt
