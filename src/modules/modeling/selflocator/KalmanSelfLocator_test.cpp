#include "modules/modeling/selflocator/KalmanSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/LocalizationTrial.h"
#include "modules/modeling/testing/Locators.h"

namespace gt {
namespace {

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

TEST(KalmanSelfLocator, FindsItselfWithinTenImages) {
  SyntheticWorld standing;
  standing.walks = false;
  standing.turnsHeadAlways = true;
  std::vector<double> first, again;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SyntheticRobot robot{seed, standing};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    const auto locate = [&](const SyntheticRobot& r) { return locator(seenBy(r)); };
    first.push_back(imagesUntilLocalized(robot, 500, locate));
    follow(robot, 100, locate);
    robot.kidnap();
    again.push_back(imagesUntilLocalized(robot, 500, locate));
  }
  EXPECT_LE(quantile(first, 0.5), 10);
  EXPECT_LE(quantile(again, 0.5), 10);
}

/// A camera that is better than the parameters state: the locator learns so.
TEST(KalmanSelfLocator, LearnsHowTheCameraErrs) {
  const auto meanError = [](double learning) {
    std::vector<double> errors;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SyntheticRobot robot{seed};
      LocatorOf<KalmanSelfLocator> locator{
          {.commonAngle = 0.06, .learning = learning, .tiltError = 0.06}, seed};
      const auto locate = [&](const SyntheticRobot& r) { return locator(seenBy(r)); };
      follow(robot, 750, locate);
      const LocalizationTrial trial = follow(robot, 2000, locate);
      errors.insert(errors.end(), trial.errors.begin(), trial.errors.end());
    }
    return mean(errors);
  };
  EXPECT_LT(meanError(0.01), 0.9 * meanError(0));
}

/// One beacon that is taken for another one, now and then, moves no robot that knows where it is.
TEST(KalmanSelfLocator, AMisnamedBeaconDoesNotMoveIt) {
  int jumps = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SyntheticRobot robot{seed};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    follow(robot, 750, [&](const SyntheticRobot& r) { return locator(seenBy(r)); });
    for (int i = 0; i < 1000; ++i) {
      robot.step();
      if (i % 25 == 0 && robot.percept.numberOfFlags > 0) {
        FlagType& name = robot.percept.flags[0].type;
        name = static_cast<FlagType>((static_cast<std::size_t>(name) + 3) % enumCount<FlagType>);
      }
      jumps += (locator(seenBy(robot)).pose.translation - robot.pose.translation).norm() > 400;
    }
  }
  EXPECT_LE(jumps, 4);
}

/// Put to the mirror image of its place, without beacons, a robot sees nothing that tells it so but
/// the goals: with the first one it knows.
TEST(KalmanSelfLocator, LeavesTheMirrorImageWhenAGoalIsSeen) {
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SyntheticRobot robot{seed, {.flags = false, .turnsHeadAlways = true, .walks = false}};
    LocatorOf<KalmanSelfLocator> locator{{}, seed};
    follow(robot, 200, [&](const SyntheticRobot& r) { return locator(seenBy(r)); });
    robot.pose = Pose2D{pi, 0, 0} * robot.pose;
    int distinguished = 0;
    for (int i = 0; i < 200; ++i) {
      robot.step();
      const Pose2D pose = locator(seenBy(robot)).pose;
      distinguished += distinguished > 0 || robot.percept.numberOfGoals > 0;
      wrong +=
          distinguished > 0 && std::abs(normalize(pose.rotation - robot.pose.rotation)) > pi / 2;
    }
    EXPECT_GT(distinguished, 0);
  }
  EXPECT_LE(wrong, 25) << "two or three images of each";
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
