#include "modules/modeling/team/DefaultTeamMessageSender.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(DefaultTeamMessageSender, TellsPoseBallAndRole) {
  DefaultTeamMessageSender sender;
  const RobotPose pose{{pi / 2, 100, 200}, 0.7};
  BallModel ball;
  ball.position = {1000, 0};
  ball.speed = {0, 50};
  ball.standardDeviation = 70;
  ball.lastSeen = {4321};
  PlayersCollection players;
  players.seenOpponents = {{{10, 20}, {4500}, 0.8, 0, 90}};
  players.opponents = {{{70, 80}, {4900}, 0.9}};
  const BehaviorTeamMessage behavior{DynamicRole::striker, 1234};
  FrameInfo frame;
  frame.time = {5000};
  Player player;
  player.role = PlayerRole::striker2;
  TeamMessage message;
  message.opponents[1].validity = 1;  // of the last message
  sender.update(pose, ball, players, behavior, frame, player, message);
  EXPECT_EQ(message.playerNumber, 4);
  EXPECT_EQ(message.timeSent, frame.time);
  EXPECT_EQ(message.robotPose.translation, pose.pose.translation);
  EXPECT_EQ(message.robotPoseValidity, 0.7);
  EXPECT_LT((message.ballSpeed - Vector2d{-50, 0}).norm(), 1e-9);
  EXPECT_EQ(message.ballStandardDeviation, 70);
  EXPECT_LT((message.ballPosition - Vector2d{100, 1200}).norm(), 1e-9);
  EXPECT_EQ(message.ballLastSeen, ball.lastSeen);
  EXPECT_EQ(message.opponents[0].position, Vector2d(10, 20)) << "what it sees, not what it heard";
  EXPECT_EQ(message.opponents[0].lastSeen, Time{4500});
  EXPECT_EQ(message.opponents[0].validity, 0.8);
  EXPECT_EQ(message.opponents[0].standardDeviation, 90);
  EXPECT_EQ(message.opponents[1].validity, 0) << "there is none";
  EXPECT_EQ(message.behavior.role, DynamicRole::striker);
  EXPECT_EQ(message.behavior.estimatedTimeToReachBall, 1234);
}

}  // namespace
}  // namespace gt
