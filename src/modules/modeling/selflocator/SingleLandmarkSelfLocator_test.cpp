#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

/// A locator on the test bench, or with percepts made by hand.
struct LandmarkBench {
  RobotPose operator()(const SyntheticRobot& robot) {
    locator.update(robot.percept, robot.odometry, robot.field, robot.player, estimate, debug);
    return estimate;
  }
  /// An image in which a robot that stands at the true pose sees landmarks without any error.
  const RobotPose& see(const Pose2D& truth, const std::vector<FlagType>& flags, bool goal = false) {
    percept = {};
    percept.time = time = time + 40;
    for (const FlagType type : flags) {
      const Vector2d offset = relative(truth, positionOf(type, player.teamColor, field));
      FlagPercept& flag = percept.flags[static_cast<std::size_t>(percept.numberOfFlags++)];
      flag.type = type;
      flag.distance = offset.norm();
      flag.angle = angleOf(offset);
    }
    if (goal) {
      percept.numberOfGoals = 1;
      percept.goals[0].color = GoalColor::skyblue;
      percept.goals[0].angle = angleOf(relative(truth, {field.xGroundline, 0}));
    }
    locator.update(percept, odometry, field, player, estimate, debug);
    return estimate;
  }

  SingleLandmarkSelfLocator locator;
  LandmarksPercept percept;
  OdometryData odometry;
  FieldDimensions field;
  Player player{TeamColor::red, PlayerRole::striker1};
  Time time{1000};
  RobotPose estimate;
  Debug debug{1024};
};

constexpr FlagType leftFlag = FlagType::greenAbovePink;
constexpr FlagType rightFlag = FlagType::pinkAboveSkyblue;

TEST(SingleLandmarkSelfLocator, ApproachesALandmarkOnlyAlongTheStraightLineToIt) {
  // Report, figure 3.6a: from the middle of the field, the flag at its left edge is straight to the
  // left. Wherever the robot really stands, the estimate stays on that line.
  LandmarkBench bench;
  const Pose2D truth{0.5, -600, 700};
  const Vector2d flag = positionOf(leftFlag, TeamColor::red, bench.field);
  for (int i = 0; i < 500; ++i) bench.see(truth, {leftFlag});
  EXPECT_NEAR(bench.estimate.pose.translation.x(), 0, 1);
  EXPECT_NEAR((bench.estimate.pose.translation - flag).norm(), (truth.translation - flag).norm(),
              1);
  EXPECT_NEAR(angleOf(relative(bench.estimate.pose, flag)), angleOf(relative(truth, flag)), 0.01);
}

TEST(SingleLandmarkSelfLocator, SettlesDownWhereDifferentLandmarksAgree) {
  LandmarkBench bench;
  const Pose2D truth{0.5, -600, 700};
  for (int i = 0; i < 500; ++i) bench.see(truth, {i % 20 < 10 ? leftFlag : rightFlag});
  EXPECT_LT((bench.estimate.pose.translation - truth.translation).norm(), 100);
  EXPECT_LT(std::abs(normalize(bench.estimate.pose.rotation - truth.rotation)), 0.1);
  EXPECT_GT(bench.estimate.validity, 0.1);
}

TEST(SingleLandmarkSelfLocator, StallsWithoutProgressiveness) {
  LandmarkBench bench;
  bench.locator.parameters.progressiveness = 0;
  for (int i = 0; i < 100; ++i) bench.see({0.5, -600, 700}, {leftFlag, rightFlag}, true);
  EXPECT_EQ(bench.estimate.pose.translation, Vector2d::Zero());
  EXPECT_EQ(bench.estimate.pose.rotation, 0);
}

TEST(SingleLandmarkSelfLocator, TheGoalOverrulesTheOrientationOfFlags) {
  // The flags' bearings are wrong by half a radian.
  LandmarkBench bench;
  const Pose2D truth{0, 0, 0}, turned{-0.5, 0, 0};
  const auto orientation = [&](bool goal) {
    for (int i = 0; i < 300; ++i) {
      bench.see(turned, {leftFlag});
      if (goal) bench.see(truth, {}, true);
    }
    return bench.estimate.pose.rotation;
  };
  EXPECT_NEAR(orientation(false), -0.5, 0.02);
  EXPECT_GT(orientation(true), -0.25);
}

TEST(SingleLandmarkSelfLocator, IsLessReliableTheFartherItWalksAndWhereMeasurementsDisagree) {
  const auto walked = [](double mm, int pictures) {
    LandmarkBench bench;
    for (int i = 0; i < 200; ++i) bench.see({}, {leftFlag, rightFlag}, true);
    const double before = bench.estimate.validity;
    for (int i = 0; i < pictures; ++i) {
      bench.odometry.pose = bench.odometry.pose * Pose2D{0, mm / pictures, 0};
      bench.see({}, {});
    }
    return bench.estimate.validity / before;
  };
  EXPECT_LT(walked(500, 25), 0.9 * walked(0, 25));
  EXPECT_LT(walked(1000, 25), 0.9 * walked(500, 25));
  EXPECT_LT(walked(0, 250), 0.9 * walked(0, 25));  // and by time alone

  LandmarkBench bench;
  for (int i = 0; i < 200; ++i) bench.see({}, {leftFlag, rightFlag}, true);
  const double agreed = bench.estimate.validity;
  bench.see({2, 1500, -900}, {leftFlag, rightFlag}, true);
  EXPECT_GT(bench.estimate.validity, 0.6 * agreed);  // a single misreading does little
  for (int i = 0; i < 200; ++i)
    bench.see(i % 2 == 0 ? Pose2D{2, 1500, -900} : Pose2D{-2, -1500, 900}, {leftFlag, rightFlag});
  EXPECT_LT(bench.estimate.validity, 0.5 * agreed);
}

TEST(SingleLandmarkSelfLocator, OdometryMovesThePoseWhileNothingIsSeen) {
  LandmarkBench bench;
  for (int i = 0; i < 200; ++i) bench.see({0.3, 100, -200}, {leftFlag, rightFlag}, true);
  const Pose2D before = bench.estimate.pose, step{0.4, 300, 50};
  bench.odometry.pose = bench.odometry.pose * step;
  bench.see({}, {});
  EXPECT_NEAR((bench.estimate.pose.translation - (before * step).translation).norm(), 0, 1e-9);
  EXPECT_NEAR(bench.estimate.pose.rotation, before.rotation + 0.4, 1e-9);
}

TEST(SingleLandmarkSelfLocator, FollowsAWalkingRobotAndFindsOneThatWasPutElsewhere) {
  std::vector<double> errors, again;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SyntheticRobot robot{seed};
    LandmarkBench bench;
    follow(robot, 250, bench);
    const LocalizationTrial trial = follow(robot, 3000, bench);
    errors.insert(errors.end(), trial.errors.begin(), trial.errors.end());
    robot.kidnap();
    follow(robot, 250, bench);
    again.push_back(quantile(follow(robot, 250, bench).errors, 0.5));
  }
  EXPECT_LT(quantile(errors, 0.5), 250);
  EXPECT_LT(quantile(again, 0.5), 300);
}

// Report 3.3.1.1: what comes last has the last word.
TEST(SingleLandmarkSelfLocator, AGoalComesAfterAFlagOfTheSameImage) {
  LandmarkBench bench;
  bench.locator.parameters.flagAngleQuality = bench.locator.parameters.goalAngleQuality;
  constexpr double wrong = 0.5;
  bench.see({-wrong, 0, 0}, {leftFlag}, true);
  bench.percept.flags[0].distance = 0;
  bench.percept.goals[0].angle = 0;
  for (int i = 0; i < 100; ++i) {
    bench.percept.time = bench.percept.time + 40;
    bench.locator.update(bench.percept, bench.odometry, bench.field, bench.player, bench.estimate,
                         bench.debug);
  }
  EXPECT_GT(bench.estimate.pose.rotation, -0.49 * wrong) << "closer to the goal's";
  EXPECT_LT(bench.estimate.pose.rotation, 0) << "but not without the flag";
}

}  // namespace
}  // namespace gt
