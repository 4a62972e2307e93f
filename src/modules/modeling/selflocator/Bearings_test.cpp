#include "modules/modeling/selflocator/Bearings.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

TEST(Bearings, FastFunctionsAreExactEnough) {
  Random random{1};
  for (int i = 0; i < 100000; ++i) {
    const auto x = static_cast<float>(random.symmetric());
    const auto y = static_cast<float>(random.symmetric());
    EXPECT_NEAR(fastAtan2(y, x), std::atan2(y, x), 2e-5) << y << ' ' << x;
    const auto exponent = static_cast<float>(-60 * random.uniform());
    EXPECT_NEAR(fastExp(exponent) / std::exp(exponent), 1, 1e-5) << exponent;
  }
  EXPECT_EQ(fastAtan2(0, 0), 0);
  EXPECT_NEAR(std::abs(fastAtan2(0, -1)), pi, 1e-6);
  EXPECT_EQ(fastExp(0), 1);
  EXPECT_LT(fastExp(-1e30f), 1e-30f);
}

TEST(Bearings, DeviationFollowsTheFormulaOfTheReport) {
  Random random{2};
  for (int i = 0; i < 1000; ++i) {
    const Pose2D robot{pi * random.symmetric(), 1500 * random.symmetric(),
                       1000 * random.symmetric()};
    const Vector2d offset{150, 30}, landmark{2100, 1400};
    const double measured = pi * random.symmetric();
    const Vector2d toFlag = landmark - robot * offset;
    const double flag = angleOf(toFlag) - robot.rotation;
    const double edge = std::asin(50 / toFlag.norm());  // (3.10)
    for (const double side : {1.0, 0.0, -1.0}) {
      const Bearing bearing{landmark, 50 * side, direction(measured)};
      const double expected = normalize(measured - (flag + side * edge));
      const Vector2d camera = robot * offset, heading = direction(robot.rotation);
      const double actual = BearingTerms{bearing}.deviation(
          static_cast<float>(camera.x()), static_cast<float>(camera.y()),
          static_cast<float>(heading.x()), static_cast<float>(heading.y()));
      EXPECT_NEAR(normalize(actual - expected), 0, 3e-5);
    }
  }
}

TEST(Bearings, EdgesOnTheBorderAreNotUsed) {
  const FieldDimensions field;
  LandmarksPercept percept;
  percept.numberOfFlags = 1;
  percept.flags[0].type = FlagType::greenAbovePink;
  percept.flags[0].boundary = {0.3, 0.2, 0, 0, true, false, false, false};
  percept.numberOfGoals = 1;
  percept.goals[0].color = GoalColor::skyblue;
  percept.goals[0].boundary = {0.1, -0.4, 0, 0, false, true, false, false};
  const Bearings bearings = bearingsIn(percept, TeamColor::red, field);
  ASSERT_EQ(bearings.count, 2);
  EXPECT_EQ(bearings.list[0].landmark, (Vector2d{0, field.flagY}));
  EXPECT_EQ(bearings.list[0].radius, -field.flagRadius);
  EXPECT_NEAR(angleOf(bearings.list[0].direction), 0.2, 1e-12);
  EXPECT_EQ(bearings.list[1].landmark, (Vector2d{field.xGroundline, field.yGoal}));
  EXPECT_EQ(bearings.list[1].radius, 0);
}

TEST(Bearings, PostsSwapSidesInTheOwnGoal) {
  const FieldDimensions field;
  // Who looks at a goal from the field sees its left post on the left.
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const GoalColor goal : {GoalColor::yellow, GoalColor::skyblue}) {
      const Vector2d left = positionOfPost(goal, true, team, field);
      const Vector2d right = positionOfPost(goal, false, team, field);
      EXPECT_GT(right.x() * left.y() - right.y() * left.x(), 0);  // Counterclockwise.
      EXPECT_EQ(left.x() < 0, goal == ownGoal(team));
      EXPECT_EQ(left.x(), right.x());
      EXPECT_EQ(left.y(), -right.y());
    }
}

}  // namespace
}  // namespace gt
