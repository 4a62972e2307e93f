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
  const BehaviorTeamMessage behavior{DynamicRole::striker, 1234};
  FrameInfo frame;
  frame.time = {5000};
  Player player;
  player.role = PlayerRole::striker2;
  TeamMessage message;
  sender.update(pose, ball, behavior, frame, player, message);
  EXPECT_EQ(message.playerNumber, 4);
  EXPECT_EQ(message.timeSent, frame.time);
  EXPECT_EQ(message.robotPose.translation, pose.pose.translation);
  EXPECT_EQ(message.robotPoseValidity, 0.7);
  EXPECT_LT((message.ballSpeed - Vector2d{-50, 0}).norm(), 1e-9);
  EXPECT_EQ(message.ballStandardDeviation, 70);
  EXPECT_LT((message.ballPosition - Vector2d{100, 1200}).norm(), 1e-9);
  EXPECT_EQ(message.ballLastSeen, ball.lastSeen);
  EXPECT_EQ(message.behavior.role, DynamicRole::striker);
  EXPECT_EQ(message.behavior.estimatedTimeToReachBall, 1234);
}

}  // namespace
}  // namespace gt
