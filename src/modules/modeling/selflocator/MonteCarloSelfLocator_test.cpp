#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"

#include <gtest/gtest.h>

#include <numeric>

#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

/// A locator on the test bench.
struct Bench {
  explicit Bench(std::uint64_t seed) : random{seed} {}

  RobotPose operator()(const SyntheticRobot& robot) {
    locator.update(robot.percept, robot.odometry, robot.field, robot.player, estimate, random,
                   debug);
    return estimate;
  }

  MonteCarloSelfLocator locator;
  RobotPose estimate;
  Random random;
  Debug debug{1024};
};

TEST(MonteCarloSelfLocator, FollowsAWalkingRobot) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SyntheticRobot robot{seed};
    Bench bench{seed};
    follow(robot, 125, bench);
    const LocalizationTrial trial = follow(robot, 3000, bench);
    EXPECT_LT(trial.longestLost, 10) << "lost itself, seed " << seed;
    errors.insert(errors.end(), trial.errors.begin(), trial.errors.end());
  }
  EXPECT_LT(quantile(errors, 0.5), 60);
  EXPECT_LT(quantile(errors, 0.95), 350);
}

TEST(MonteCarloSelfLocator, FindsItselfAgainAfterTheRefereePutItElsewhere) {
  SyntheticWorld standing;
  standing.walks = false;
  standing.turnsHeadAlways = true;
  std::vector<double> first, again;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SyntheticRobot robot{seed, standing};
    Bench bench{seed};
    first.push_back(imagesUntilLocalized(robot, 500, bench));
    follow(robot, 100, bench);
    robot.kidnap();
    again.push_back(imagesUntilLocalized(robot, 500, bench));
  }
  EXPECT_LE(quantile(first, 0.5), 40);  // report 3.3.2.5: 14 to 40 images
  EXPECT_LE(quantile(again, 0.5), 40);
  EXPECT_LT(quantile(first, 1), 500);
  EXPECT_LT(quantile(again, 1), 500);
}

TEST(MonteCarloSelfLocator, CertaintyTellsWhetherThePoseIsKnown) {
  SyntheticRobot robot{7};
  Bench bench{7};
  const double before = bench(robot).validity;  // Nothing seen yet.
  follow(robot, 250, bench);
  EXPECT_LT(before, 0.3);
  EXPECT_GT(bench.estimate.validity, 0.6);
}

TEST(MonteCarloSelfLocator, OdometryMovesThePoseWhileNothingIsSeen) {
  SyntheticRobot robot{3};
  Bench bench{3};
  follow(robot, 500, bench);
  const Pose2D before = bench.estimate.pose;
  robot.percept = {};
  const Pose2D step{0.01, 5, 1};
  Pose2D sum;
  for (int i = 0; i < 50; ++i) {
    robot.percept.time = robot.percept.time + 40;
    robot.odometry.pose = robot.odometry.pose * step;
    sum = sum * step;
    bench(robot);
  }
  const Pose2D expected = before * sum;
  EXPECT_LT((bench.estimate.pose.translation - expected.translation).norm(), 60);
  EXPECT_NEAR(normalize(bench.estimate.pose.rotation - expected.rotation), 0, 0.15);
}

TEST(MonteCarloSelfLocator, AnImageIsUsedOnce) {
  SyntheticRobot robot{4};
  Bench bench{4};
  do robot.step();
  while (robot.percept.numberOfFlags == 0);
  bench(robot);
  const std::vector<float> probabilities = bench.locator.particles().probability;
  bench(robot);
  EXPECT_EQ(bench.locator.particles().probability, probabilities);
}

TEST(MonteCarloSelfLocator, ProbabilitiesChangeByBoundedSteps) {
  SyntheticRobot robot{5};
  Bench bench{5};
  bench.locator.parameters.templates.replacement = 0;  // Else new particles would blur the image.
  bench(robot);
  double low = 1, high = 0;
  const double start = bench.locator.parameters.templates.newProbability;
  const double fall = bench.locator.parameters.landmarks.fall;
  for (int picture = 1; picture <= 10;) {
    robot.step();
    if (bearingsIn(robot.percept, robot.player.teamColor, robot.field).count == 0) continue;
    bench(robot);
    for (const double probability : bench.locator.particles().probability) {
      low = std::min(low, probability);
      high = std::max(high, probability);
    }
    EXPECT_GE(low, start - fall * picture - 1e-6);  // (3.13)
    EXPECT_LE(high, 1 + 1e-6);
    ++picture;
  }
  EXPECT_LT(low, start - 2 * fall);
}

TEST(MonteCarloSelfLocator, SameSeedGivesTheSamePose) {
  SyntheticRobot a{6}, b{6};
  Bench benchA{6}, benchB{6};
  for (int i = 0; i < 200; ++i) {
    a.step();
    b.step();
    const Pose2D poseA = benchA(a).pose, poseB = benchB(b).pose;
    ASSERT_EQ(poseA.translation, poseB.translation);
    ASSERT_EQ(poseA.rotation, poseB.rotation);
  }
}

TEST(MonteCarloSelfLocator, NumberOfParticlesIsAParameter) {
  SyntheticRobot robot{8};
  Bench bench{8};
  for (const int particles : {100, 30, 300}) {
    bench.locator.parameters.particles = particles;
    follow(robot, 10, bench);
    EXPECT_EQ(bench.locator.particles().size(), static_cast<std::size_t>(particles));
  }
}

}  // namespace
}  // namespace gt
