#include "modules/modeling/selflocator/PoseTemplates.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/Random.h"
#include "modules/modeling/testing/SyntheticRobot.h"

namespace gt {
namespace {

const FieldDimensions soccerField;

Pose2D anyPose(Random& random) {
  const double x = 1900 * random.symmetric(), y = 1200 * random.symmetric();
  return {pi * random.symmetric(), x, y};
}

Vector2d flagPosition(std::uint64_t i) {
  return positionOf(static_cast<FlagType>(i), TeamColor::red, soccerField);
}

double distanceBetween(const Pose2D& a, const Pose2D& b) {
  return (a.translation - b.translation).norm() +
         500 * std::abs(normalize(a.rotation - b.rotation));
}

TEST(PoseTemplates, ThreeExactBearingsGiveTheExactPose) {
  Random random{3};
  int found = 0;
  for (int i = 0; i < 10000; ++i) {
    const Pose2D pose = anyPose(random);
    const auto first = random.index(6);
    std::array<Sighting, 3> sightings;
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Vector2d landmark = flagPosition((first + k) % 6);
      sightings[k] = {landmark, relative(pose, landmark) * random.uniform(0.1, 10)};
    }
    const auto result = triangulate(sightings[0], sightings[1], sightings[2]);
    if (!result) continue;  // On the circle through the three flags.
    ++found;
    EXPECT_LT(distanceBetween(*result, pose), 0.01);
  }
  EXPECT_GT(found, 9900);
}

TEST(PoseTemplates, NothingIsFoundOnTheCircleThroughTheLandmarks) {
  std::array<Sighting, 3> sightings;
  const Pose2D pose{0.3, 1000, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector2d landmark = direction(1 + static_cast<double>(i)) * 1000;
    sightings[i] = {landmark, relative(pose, landmark)};
  }
  EXPECT_FALSE(triangulate(sightings[0], sightings[1], sightings[2]));
}

TEST(PoseTemplates, ContradictoryDirectionsGiveNothing) {
  // All three straight ahead, though they stand apart.
  EXPECT_FALSE(triangulate({{2100, 1400}, {1, 0}}, {{0, -1400}, {1, 0}}, {{-2100, 0}, {1, 0}}));
}

TEST(PoseTemplates, OneDistanceAndOneMoreBearingGiveThePose) {
  Random random{4};
  for (int i = 0; i < 10000; ++i) {
    const Pose2D pose = anyPose(random);
    const auto first = random.index(6);
    const Vector2d a = flagPosition(first), b = flagPosition((first + 1 + random.index(5)) % 6);
    std::array<Pose2D, 2> poses;
    const int found = posesFrom({a, relative(pose, a)}, {b, relative(pose, b) * 0.01}, poses);
    ASSERT_GE(found, 1);
    double best = distanceBetween(poses[0], pose);
    if (found == 2) best = std::min(best, distanceBetween(poses[1], pose));
    // Where the bearings cross at a right angle both solutions meet, and rounding is magnified.
    EXPECT_LT(best, 0.5);
  }
}

TEST(PoseTemplates, ADistanceThatTheBearingsForbidGivesNothing) {
  std::array<Pose2D, 2> poses;
  EXPECT_EQ(posesFrom({{0, 0}, {5000, 0}}, {{100, 0}, {0, 1}}, poses), 0);
}

TEST(PoseTemplates, ExactPerceptsGiveTheTruePoseOnceEach) {
  SyntheticWorld exact;
  exact.slip = exact.stepNoise = exact.commonNoise = exact.edgeNoise = exact.sway = 0;
  exact.outliers = exact.hiddenPosts = 0;
  exact.secondsBetweenBlocks = 1e12;
  exact.turnsHeadAlways = true;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SyntheticRobot robot{seed, exact};
    Random random{seed};
    PoseTemplates templates;
    Pose2D before;
    int taken = 0, near = 0;
    for (int i = 0; i < 500; ++i) {
      robot.step();
      templates.move(robot.odometry.pose.relativeTo(before));
      before = robot.odometry.pose;
      templates.update(robot.percept, robot.player.teamColor, robot.field);
      const int size = templates.size();
      for (int k = 0; k < size; ++k) {
        const auto pose = templates.take(random);
        ASSERT_TRUE(pose);
        ++taken;
        near += distanceBetween(*pose, robot.pose) < 400;
      }
      EXPECT_FALSE(templates.take(random));
    }
    // The others are the second solutions, and those made with distances, which stay noisy.
    EXPECT_GT(taken, 500);
    EXPECT_GT(near, taken / 2);
  }
}

TEST(PoseTemplates, MemorizedFlagsMoveWithTheRobot) {
  // One flag in each image, between them the robot walks: at last three bearings meet.
  const Pose2D walk{0.2, 100, 20};
  Pose2D pose{0.4, -300, 200};
  PoseTemplates templates;
  for (const FlagType type :
       {FlagType::pinkAboveSkyblue, FlagType::greenAbovePink, FlagType::yellowAbovePink}) {
    pose = pose * walk;
    templates.move(walk);
    const Vector2d seen = relative(pose, positionOf(type, TeamColor::red, soccerField));
    LandmarksPercept percept;
    percept.numberOfFlags = 1;
    percept.flags[0].type = type;
    percept.flags[0].angle = angleOf(seen);
    percept.flags[0].distance = seen.norm();
    templates.update(percept, TeamColor::red, soccerField);
  }
  Random random{1};
  ASSERT_EQ(templates.size(), 1);
  EXPECT_LT(distanceBetween(*templates.take(random), pose), 0.01);
}

}  // namespace
}  // namespace gt
