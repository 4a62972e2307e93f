#include "modules/kinematics/BodyPosture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/Random.h"
#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

/// Heights of the soles above the ground, fore and hind the lowest of two.
std::pair<double, double> clearances(const RobotDimensions& robot, const JointAngles& angles) {
  const auto pose = bodyPose(bodyPosture(robot, angles));
  const auto feet = footPositions(robot, angles);
  const auto sole = [&](std::size_t i) { return (pose * feet[i]).z() - robot.footRadius; };
  return {std::min(sole(0), sole(1)), std::min(sole(2), sole(3))};
}

TEST(BodyPosture, LevelWhenAllFeetAreAtOneDepth) {
  const RobotDimensions robot;
  JointAngles angles;
  for (const auto leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    const Vector3d foot = shoulderOf(robot, leg) + Vector3d{10, isLeft(leg) ? 20.0 : -20.0, -100};
    setLeg(angles, leg, legAngles(robot, leg, foot).angles);
  }
  const auto posture = bodyPosture(robot, angles);
  EXPECT_NEAR(posture.tilt, 0, 1e-9);
  EXPECT_NEAR(posture.height, 100 + robot.footRadius, 1e-9);
}

TEST(BodyPosture, OneForeAndOneHindFootTouchTheGround) {
  const RobotDimensions robot;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random{seed};
    for (int i = 0; i < 300; ++i) {
      JointAngles angles;
      for (const auto leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
        setLeg(angles, leg,
               {random.uniform(-0.6, 0.6), random.uniform(-0.1, 0.5), random.uniform(0, 1.6)});
      const auto [fore, hind] = clearances(robot, angles);
      EXPECT_NEAR(fore, 0, 1e-9);
      EXPECT_NEAR(hind, 0, 1e-9);
    }
  }
}

TEST(BodyPosture, LongerForeLegsLiftTheNose) {
  const RobotDimensions robot;
  JointAngles angles;
  for (const auto leg : {Leg::hindRight, Leg::hindLeft}) setLeg(angles, leg, {0, 0, 1.5});
  const auto posture = bodyPosture(robot, angles);
  EXPECT_GT(posture.tilt, 0.1);
  EXPECT_GT((bodyPose(posture) * Vector3d{75, 0, 50}).z(),
            (bodyPose(posture) * Vector3d{-75, 0, 50}).z());
}

TEST(BodyPosture, AtRestAStandingBodyStandsOnItsFeet) {
  const RobotDimensions robot;
  JointAngles angles;
  for (const auto leg : {Leg::hindRight, Leg::hindLeft}) setLeg(angles, leg, {0, 0, 0.4});
  const BodyPosture byLegs = bodyPosture(robot, angles);
  const Vector3d felt = bodyPose(byLegs).rotation.transpose() * Vector3d{0, 0, 9810};
  const BodyPosture atRest = restingPosture(robot, angles, felt);
  EXPECT_NEAR(atRest.tilt, byLegs.tilt, 1e-9);
  EXPECT_NEAR(atRest.roll, 0, 1e-9);
  EXPECT_NEAR(atRest.height, byLegs.height, 1e-6);
}

// With its legs stretched out to the sides it lies on chest and rump, or on the knee of one side.
TEST(BodyPosture, AtRestABodyWithoutLegsBelowLiesOnItsTrunk) {
  const RobotDimensions robot;
  JointAngles angles;
  for (const auto leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    setLeg(angles, leg, {0, fromDegrees(85), 0});
  const BodyPosture level = restingPosture(robot, angles, {0, 0, 9810});
  EXPECT_NEAR(level.height, 40, 1e-9) << "the chest's radius below its middle";
  const BodyPosture nose =
      restingPosture(robot, angles, {9810 * std::sin(0.2), 0, 9810 * std::cos(0.2)});
  EXPECT_NEAR(nose.tilt, 0.2, 1e-9);
  EXPECT_NEAR((bodyPose(nose) * Vector3d{-82, 0, -38}).z(), 0, 1e-9) << "on its rump";
  const BodyPosture left =
      restingPosture(robot, angles, {0, -9810 * std::sin(0.3), 9810 * std::cos(0.3)});
  EXPECT_NEAR(left.roll, -0.3, 1e-9);
  double lowest = 1e9;
  for (const auto leg : {Leg::foreLeft, Leg::hindLeft}) {
    const Pose3D pose = bodyPose(left);
    lowest = std::min({lowest,
                       (pose * footPosition(robot, leg, legOf(angles, leg))).z() - robot.footRadius,
                       (pose * kneePosition(robot, leg, legOf(angles, leg))).z() - 14});
  }
  EXPECT_NEAR(lowest, 0, 1e-9) << "on the legs of the lower side";
}

}  // namespace
}  // namespace gt
