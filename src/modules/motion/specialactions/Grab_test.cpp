#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modules/motion/testing/MotionHarness.h"

namespace gt {
namespace {

/// A robot that has grabbed.
MotionHarness grabbed() {
  MotionHarness motion;
  motion.steps(150);
  motion.perform("grab");
  motion.steps(400);
  EXPECT_TRUE(motion.performs("grab")) << "it holds the ball until something else is requested";
  return motion;
}

/// By how much head and legs differ at most (rad).
double difference(const JointAngles& one, const JointAngles& other) {
  double most = std::abs(one[Joint::headTilt] - other[Joint::headTilt]);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    for (int number = 1; number <= 3; ++number) {
      const Joint joint = legJoint(leg, number);
      most = std::max(most, std::abs(one[joint] - other[joint]));
    }
  return most;
}

TEST(Grab, TurnsWithTheBallWithoutLettingGo) {
  MotionHarness motion = grabbed();
  const JointAngles holds = motion.joints.angles;
  motion.walk(0, 0, 0);
  motion.request.walkType = WalkType::turnWithBall;
  for (int i = 0; i < 50; ++i) {
    motion.step();
    EXPECT_LT(difference(motion.joints.angles, holds), 0.05);
  }
  motion.request.walk.rotation = 1;
  motion.steps(250);
  EXPECT_EQ(motion.info.executed.walkType, WalkType::turnWithBall);
  EXPECT_GT(motion.odometry.pose.rotation, 0.5);
  EXPECT_NEAR(motion.joints.angles[Joint::headTilt], holds[Joint::headTilt], 0.01);
  motion.request.type = MotionType::stand;
  motion.steps(100);
  EXPECT_LT(difference(motion.joints.angles, holds), 0.05) << "it stands as it turned";
}

TEST(Grab, StandsAsAlwaysAfterTheKick) {
  MotionHarness motion;
  motion.steps(150);
  const JointAngles stand = motion.joints.angles;
  motion.perform("grab");
  motion.steps(400);
  motion.perform("grabKick");
  motion.steps(10);
  motion.request = {};
  motion.steps(400);
  EXPECT_EQ(motion.info.executed.type, MotionType::stand);
  EXPECT_LT(difference(motion.joints.angles, stand), 0.01);
}

}  // namespace
}  // namespace gt
