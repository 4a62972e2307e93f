#include "modules/motion/head/ActiveVisionHeadControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gt {
namespace {

/// A robot that stands and knows where, whose head follows what is requested, and which sees a ball
/// whenever it looks at it.
struct Watcher {
  ActiveVisionHeadControl control;
  HeadControlMode mode{HeadMode::searchAuto};
  BallModel ball;
  RobotPose pose{{}, 1};
  PlayersCollection players;
  SensorDataBuffer sensors;
  FrameInfo frame{{10000}};
  HeadMotionRequest request;
  std::vector<double> glances;  ///< Pan of each, where it was farthest from the ball.
  int longest = 0;              ///< ms, of a glance

  Watcher() { ball.position = {700, 0}; }

  void run(double seconds) {
    double farthest = 0;
    int away = 0;
    for (int i = static_cast<int>(seconds * 125); i > 0; --i) {
      frame.time.ms += 8;
      const bool sees = std::abs(request.pan) < 0.4 && std::abs(request.tilt + 0.25) < 0.4;
      ball.consecutiveTimeSeen = sees ? ball.consecutiveTimeSeen + 8 : 0;
      if (sees) ball.lastSeen = frame.time;
      const HeadMotionRequest before = request;
      control.update(mode, ball, pose, players, sensors, {}, {}, {}, frame, request);
      request.tilt = std::clamp(request.tilt, before.tilt - 0.0168, before.tilt + 0.0168);
      request.pan = std::clamp(request.pan, before.pan - 0.024, before.pan + 0.024);
      JointAngles& joints = sensors.frames.back().joints;
      joints[Joint::headTilt] = request.tilt;
      joints[Joint::headPan] = request.pan;
      if (std::abs(request.pan) > std::abs(farthest)) farthest = request.pan;
      away = std::abs(request.pan) > 0.03 ? away + 8 : 0;
      longest = std::max(longest, away);
      if (away > 0 || std::abs(farthest) < 0.1) continue;
      glances.push_back(farthest);
      farthest = 0;
    }
  }
  /// Sets what landmarks and opponents are worth to it.
  void weigh(double landmarks, double opponents) {
    control.parameters.landmarkWeight = landmarks;
    control.parameters.opponentWeight = opponents;
  }
};

TEST(ActiveVisionHeadControl, LooksToTheSideWhereMoreLandmarksAre) {
  for (const double side : {1., -1.}) {
    Watcher robot;
    robot.weigh(1, 0);
    robot.pose.pose = {0, 0, 1200 * side};
    robot.run(1.5);
    ASSERT_FALSE(robot.glances.empty());
    EXPECT_LT(side * robot.glances.front(), -0.1) << "the goal and two flags";
  }
}

TEST(ActiveVisionHeadControl, LooksToTheSideWhereAnOpponentWasSeenLongAgo) {
  for (const double side : {1., -1.}) {
    Watcher robot;
    robot.weigh(0, 1);
    robot.run(20);  // looks around first
    robot.players.opponents.push_back({{700, 550 * side}, robot.frame.time + -4000, 1, 0});
    robot.run(2);  // what it was about
    robot.glances.clear();
    robot.run(3);
    ASSERT_FALSE(robot.glances.empty());
    for (const double glance : robot.glances) EXPECT_GT(side * glance, 0.1);
  }
}

TEST(ActiveVisionHeadControl, StaysAtTheBallIfThereIsNothingToGain) {
  Watcher robot;
  robot.weigh(0, 0);
  robot.run(10);
  EXPECT_TRUE(robot.glances.empty());
  EXPECT_LT(robot.longest, 300) << "until it has found the ball";
  Watcher other;
  other.control.parameters.ballWeight = 100;
  other.run(10);
  EXPECT_TRUE(other.glances.empty()) << "the ball is worth more than all else";
}

TEST(ActiveVisionHeadControl, LooksToBothSidesForNoLongerThanGT2003) {
  Watcher robot;
  robot.run(20);
  EXPECT_LE(robot.longest, 880);
  EXPECT_GT(robot.glances.size(), 5u);
  EXPECT_GT(std::ranges::max(robot.glances), 0.3);
  EXPECT_LT(std::ranges::min(robot.glances), -0.3);
}

TEST(ActiveVisionHeadControl, ScansBothSidesInTurnWhileItDoesNotKnowItsPose) {
  Watcher robot;
  robot.weigh(0, 0);
  robot.pose.validity = 0;
  robot.run(10);
  ASSERT_GT(robot.glances.size(), 4u);
  for (std::size_t i = 1; i < robot.glances.size(); ++i)
    EXPECT_LT(robot.glances[i] * robot.glances[i - 1], 0);
}

TEST(ActiveVisionHeadControl, HasTheOtherModesOfGT2003) {
  Watcher robot;
  robot.mode.mode = HeadMode::lookLeft;
  robot.run(2);
  EXPECT_NEAR(robot.request.pan, 1.45, 1e-6);
}

}  // namespace
}  // namespace gt
