#include "modules/perception/specialists/GoalSpecialist.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"
#include "modules/perception/testing/DrawnLandmarks.h"

namespace gt {
namespace {

using GoalSpecialistTest = DrawnLandmarks;
using GoalBehindARobot = DrawnBoxes;
using LikeAGoal = DrawnBoxes;

TEST_F(GoalSpecialistTest, MeasuresTheGoal) {
  random_ = Random{10};
  for (int i = 0; i < 20; ++i) {
    goal_ = random_.uniform(1000, 3000);
    look(random_.uniform(-0.1, 0.1), random_.uniform(-0.1, 0.02), random_.uniform(-0.15, 0.15));
    ASSERT_EQ(landmarks_.numberOfGoals, 1) << *goal_;
    const GoalPercept& seen = landmarks_.goals[0];
    EXPECT_EQ(seen.color, GoalColor::yellow);
    const auto bearing = [&](double y) {
      return angleOf(Vector2d{*goal_, y} - camera().head<2>());
    };
    if (!seen.boundary.leftOnBorder) {
      EXPECT_NEAR(seen.boundary.left, bearing(field_.yGoal), fromDegrees(0.4));
    }
    if (!seen.boundary.rightOnBorder) {
      EXPECT_NEAR(seen.boundary.right, bearing(-field_.yGoal), fromDegrees(0.4));
    }
  }
}

TEST_F(GoalSpecialistTest, LeavesTheEndOfAGoalOutsideTheImageOpen) {
  random_ = Random{11};
  goal_ = 800;
  look(0.5, 0, 0);
  ASSERT_EQ(landmarks_.numberOfGoals, 1);
  EXPECT_TRUE(landmarks_.goals[0].boundary.rightOnBorder);
  EXPECT_FALSE(landmarks_.goals[0].boundary.leftOnBorder);
}

// The camera is in front of the robot's middle, from where a goal beside it is seen elsewhere.
using GoalBesideTheRobot = DrawnBoxes;
TEST_F(GoalBesideTheRobot, IsInItsDirectionThoughItsTopIsNotSeen) {
  boxes_ = {{{400, 100, 0}, {410, 700, 300}, ColorClass::yellow}};
  look(0.9, -0.5);
  ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1);
  const GoalPercept& seen = percepts_.landmarks.goals[0];
  EXPECT_EQ(seen.distance, 0);
  const double bearing = (seen.boundary.left + seen.boundary.right) / 2;
  EXPECT_NEAR(toDegrees(seen.angle), toDegrees(std::atan2(10 + 310 * std::tan(bearing), 400)), 2.5);
}

TEST_F(GoalBehindARobot, ARobotHidesTheFootOfAGoalButNotTheGoal) {
  boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
            {{600, -200, 0}, {700, 150, 100}, ColorClass::gray},
            {{600, -200, 100}, {700, 150, 170}, ColorClass::red}};
  look(0, 0.05);
  ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1);
  const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
  EXPECT_NEAR(toDegrees(b.left), toDegrees(std::atan2(290, 1410)), 1);
  EXPECT_NEAR(toDegrees(b.right), toDegrees(std::atan2(-310, 1410)), 1);
}

// Bright parts of a robot look like an end, but no goal is that narrow.
TEST_F(GoalBehindARobot, ANarrowGoalIsHiddenOnASideThatNothingShows) {
  for (const bool hidden : {false, true}) {
    boxes_ = {{{1500, hidden ? 100. : -300., 0}, {1510, 300, 300}, ColorClass::skyblue}};
    look(0, 0);
    ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1) << hidden;
    const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
    EXPECT_EQ(b.leftOnBorder, hidden) << hidden;
    EXPECT_EQ(b.rightOnBorder, hidden) << hidden;
  }
}

// What hides its foot must be a robot: a shirt above something gray, or black legs, is no goal.
TEST_F(LikeAGoal, SomethingAboveAGrayOrBlackBoxIsNone) {
  for (const ColorClass color : {ColorClass::gray, ColorClass::black, ColorClass::blue}) {
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
              {{600, -200, 0}, {700, 150, 170}, color}};
    look(0, 0.05);
    EXPECT_EQ(percepts_.landmarks.numberOfGoals, color == ColorClass::blue) << enumName(color);
  }
}

TEST_F(LikeAGoal, APersonInItsColorBehindAGoalIsNoPartOfIt) {
  boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
            {{2600, -150, 0}, {2700, 250, 1200}, ColorClass::skyblue}};
  look(0, 0);
  ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1);
  const GoalPercept& seen = percepts_.landmarks.goals[0];
  EXPECT_NEAR(toDegrees(seen.boundary.left), toDegrees(std::atan2(290, 1410)), 1);
  EXPECT_NEAR(toDegrees(seen.boundary.right), toDegrees(std::atan2(-310, 1410)), 1);
}

// As high as it is seen, a goal would have to be far away, and so would its foot.
TEST_F(LikeAGoal, ASmallYellowBoxIsNone) {
  for (const double height : {300., 60.}) {
    boxes_ = {{{900, -60, 0}, {910, 60, height}, ColorClass::yellow}};
    look(0, -0.1);
    EXPECT_EQ(percepts_.landmarks.numberOfGoals, height == 300) << height;
  }
}

}  // namespace
}  // namespace gt
