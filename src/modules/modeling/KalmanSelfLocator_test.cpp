#include "modules/modeling/KalmanSelfLocator.h"

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

std::vector<double> errorsWith(bool flags, const KalmanSelfLocator::Parameters& parameters = {}) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SyntheticWorld world;
    world.flags = flags;
    SyntheticRobot robot{seed, world};
    LocatorOf<KalmanSelfLocator> locator{parameters, seed};
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

/// One hypothesis that no other may replace is lost sooner or later.
TEST(KalmanSelfLocator, LivesByItsManyHypotheses) {
  KalmanSelfLocator::Parameters alone;
  alone.hypotheses = 1;
  EXPECT_GT(mean(errorsWith(false, alone)), 1.2 * mean(errorsWith(false)));
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
