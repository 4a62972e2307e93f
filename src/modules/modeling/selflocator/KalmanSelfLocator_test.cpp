#include "modules/modeling/selflocator/KalmanSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/LocalizationTrial.h"
#include "modules/modeling/testing/Locators.h"

namespace gt {
namespace {

/// What the linear filter knows in closed form: two measurements of one coordinate.
TEST(PoseHypothesis, WeighsByVariances) {
  PoseHypothesis hypothesis{{0, 0, 0}, 20, 0.1};
  const auto measure = [&](double x, double deviation) {
    return hypothesis.correct(
        {x - hypothesis.pose().translation.x(), {1, 0, 0}, deviation * deviation}, 3);
  };
  const double likelihood = measure(30, 20);
  EXPECT_NEAR(hypothesis.pose().translation.x(), 15, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(0, 0), 200, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(1, 1), 400, 1e-9);
  EXPECT_NEAR(likelihood, std::sqrt(0.5) * std::exp(-900 / 800. / 2), 1e-9);
  measure(-500, 20);  // no one believes that
  EXPECT_NEAR(hypothesis.pose().translation.x(), 15, 1e-9);
}

TEST(PoseHypothesis, WhatIsNoNumberIsNotBelieved) {
  PoseHypothesis hypothesis{{0, 0, 0}, 20, 0.1};
  EXPECT_EQ(hypothesis.correct({std::nan(""), {1, 0, 0}, 400}, 3), 0);
  EXPECT_EQ(hypothesis.pose().translation, (Vector2d{0, 0}));
}

TEST(PoseHypothesis, AnUnknownRotationMakesAWalkUncertainSideways) {
  PoseHypothesis hypothesis{{pi / 2, 0, 0}, 10, 0.1};
  hypothesis.move({0, 1000, 0}, {0, 0, 0});
  EXPECT_NEAR(hypothesis.pose().translation.y(), 1000, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(0, 0), 100 + 10000, 1e-6);
  EXPECT_NEAR(hypothesis.covariance()(1, 1), 100, 1e-6);
}

TEST(PoseHypothesis, RotationsAreCorrectedAcrossTheSeam) {
  PoseHypothesis hypothesis{{pi - 0.01, 0, 0}, 10, 0.1};
  hypothesis.correct({0.04, {0, 0, 1}, 0.01}, 3);
  EXPECT_NEAR(hypothesis.pose().rotation, -pi + 0.01, 1e-9);
}

TEST(PoseHypothesis, IsItselfWhenMirroredTwice) {
  PoseHypothesis hypothesis{{1, 700, -300}, 10, 0.1};
  hypothesis.move({0.2, 500, 100}, {1, 2, 0.01});
  PoseHypothesis mirrored = hypothesis;
  mirrored.mirror();
  EXPECT_NEAR((mirrored.pose().translation + hypothesis.pose().translation).norm(), 0, 1e-9);
  EXPECT_NEAR(mirrored.covariance()(0, 1), hypothesis.covariance()(0, 1), 1e-9);
  EXPECT_NEAR(mirrored.covariance()(0, 2), -hypothesis.covariance()(0, 2), 1e-9);
  mirrored.mirror();
  EXPECT_TRUE(mirrored.isNear(hypothesis.pose(), 1e-6, 1e-9));
}

/// What a robot sees while it turns its head agrees with its pose; with the pose on the other half
/// only what is no goal.
TEST(RecentView, TellsPosesApart) {
  SyntheticRobot robot{3, {.outliers = 0, .flags = false, .turnsHeadAlways = true, .walks = false}};
  robot.pose = {0.3, 200, -400};
  EdgeModel edges;
  RecentView view;
  Random random{1};
  edges.prepare(robot.field, robot.player.teamColor);
  const Pose2D mirrored = Pose2D{pi, 0, 0} * robot.pose;
  bool goalSeen = false;
  for (int i = 0; i < 40; ++i) {
    robot.step();
    const Bearings bearings = bearingsIn(robot.percept, robot.player.teamColor, robot.field);
    goalSeen |= bearings.count > 0;
    edges.choose(robot.lines, 8, 3000, random);
    view.add(bearings, robot.percept.cameraOffset.head<2>());
    view.add(edges.chosen(), random);
    if (bearings.count < 2) continue;
    EXPECT_GT(view.agreement(robot.pose, edges.tables()), 0.7);
    EXPECT_LT(view.agreement(mirrored, edges.tables()),
              view.agreement(robot.pose, edges.tables()) - 0.05);
  }
  ASSERT_TRUE(goalSeen);
  double most = 0;
  for (int i = 0; i < 2000; ++i)
    if (const auto pose = view.drawPose(edges.tables(), robot.field, random))
      most = std::max(most, view.agreement(*pose, edges.tables()));
  EXPECT_GT(most, 0.6);
  view.clear();
  EXPECT_EQ(view.agreement(robot.pose, edges.tables()), 0);
  EXPECT_FALSE(view.drawPose(edges.tables(), robot.field, random));
}

std::vector<double> errorsWith(bool flags) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SyntheticWorld world;
    world.flags = flags;
    SyntheticRobot robot{seed, world};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    const auto locate = [&](const SyntheticRobot& r) { return locator(seenBy(r)); };
    follow(robot, 750, locate);
    const LocalizationTrial trial = follow(robot, 3000, locate);
    errors.insert(errors.end(), trial.errors.begin(), trial.errors.end());
  }
  return errors;
}

TEST(KalmanSelfLocator, FollowsAWalkingRobot) {
  const std::vector<double> errors = errorsWith(true);
  EXPECT_LT(quantile(errors, 0.5), 40);
  EXPECT_LT(quantile(errors, 0.95), 200);
}

TEST(KalmanSelfLocator, NeedsNoBeacons) {
  EXPECT_LT(quantile(errorsWith(false), 0.5), 60);
}

TEST(KalmanSelfLocator, FindsItselfWithinTenPictures) {
  SyntheticWorld standing;
  standing.walks = false;
  standing.turnsHeadAlways = true;
  std::vector<double> first, again;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SyntheticRobot robot{seed, standing};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    const auto locate = [&](const SyntheticRobot& r) { return locator(seenBy(r)); };
    first.push_back(picturesUntilLocalized(robot, 500, locate));
    follow(robot, 100, locate);
    robot.kidnap();
    again.push_back(picturesUntilLocalized(robot, 500, locate));
  }
  EXPECT_LE(quantile(first, 0.5), 10);
  EXPECT_LE(quantile(again, 0.5), 10);
}

/// Put to the mirror image of its place, without beacons, a robot sees nothing that tells it so but
/// the goals: with the first one it knows.
TEST(KalmanSelfLocator, LeavesTheMirrorImageWhenAGoalIsSeen) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SyntheticRobot robot{seed, {.flags = false, .turnsHeadAlways = true, .walks = false}};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    follow(robot, 200, [&](const SyntheticRobot& r) { return locator(seenBy(r)); });
    robot.pose = Pose2D{pi, 0, 0} * robot.pose;
    int told = 0, wrong = 0;
    for (int i = 0; i < 200; ++i) {
      robot.step();
      const Pose2D pose = locator(seenBy(robot)).pose;
      told += told > 0 || robot.percept.numberOfGoals > 0;
      wrong += told > 0 && std::abs(normalize(pose.rotation - robot.pose.rotation)) > pi / 2;
    }
    EXPECT_GT(told, 0);
    EXPECT_LE(wrong, 25) << seed;  // a second
  }
}

TEST(KalmanSelfLocator, SameSeedGivesTheSamePose) {
  SyntheticRobot robot{6};
  LocatorOf<KalmanSelfLocator> a{{}, 1}, b{{}, 1};
  for (int i = 0; i < 200; ++i) {
    robot.step();
    const Pose2D poseA = a(seenBy(robot)).pose, poseB = b(seenBy(robot)).pose;
    ASSERT_EQ(poseA.translation, poseB.translation);
    ASSERT_EQ(poseA.rotation, poseB.rotation);
  }
}

/// Percepts may be anything: never more hypotheses than asked for, and always a pose.
TEST(KalmanSelfLocator, KeepsItsNumberOfHypotheses) {
  SyntheticWorld wrong;
  wrong.outliers = 1;
  SyntheticRobot robot{2, wrong};
  LocatorOf<KalmanSelfLocator> locator{{.hypotheses = 5}, 1};
  for (int i = 0; i < 500; ++i) {
    robot.step();
    const RobotPose& pose = locator(seenBy(robot));
    EXPECT_TRUE(pose.pose.translation.allFinite());
    EXPECT_GE(pose.validity, 0);
    EXPECT_LE(pose.validity, 1);
    EXPECT_LE(locator.solution().hypotheses().size(), 5u);
  }
}

}  // namespace
}  // namespace gt
