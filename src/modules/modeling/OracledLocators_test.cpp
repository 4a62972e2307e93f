#include "modules/modeling/OracledLocators.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(OracledLocators, reportTheTruthFromTheRobotsView) {
  OracledWorldState oracle;
  oracle.robotPose = {pi / 2, 100, -200};
  oracle.ballPosition = {100, 300};
  oracle.ballSpeed = {50, 0};
  RobotPose pose;
  OracledSelfLocator{}.update(oracle, pose);
  EXPECT_EQ(pose.pose.translation, Vector2d(100, -200));
  EXPECT_EQ(pose.validity, 1);
  OracledBallLocator locator;
  BallModel ball;
  FrameInfo frame;
  for (const std::int64_t ms : {1000, 1400}) {
    frame.time = {ms};
    locator.update(oracle, frame, ball);
  }
  EXPECT_NEAR((ball.position - Vector2d{500, 0}).norm(), 0, 1e-9);
  EXPECT_NEAR((ball.speed - Vector2d{0, -50}).norm(), 0, 1e-9);
  EXPECT_EQ(ball.lastSeen, Time{1400});
  EXPECT_EQ(ball.consecutiveTimeSeen, 400);
}

}  // namespace
}  // namespace gt
