#include "modules/perception/specialists/GoalSpecialist.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"
#include "modules/perception/testing/DrawnLandmarks.h"

namespace gt {
namespace {

/// Goals and what looks like them in the white border of a field.
class DrawnGoals : public DrawnBoxes {
 protected:
  static Box border(double right = -2500, double left = 2500, double height = 300) {
    return {{1511, right, 0}, {1520, left, height}, ColorClass::white};
  }
};

using GoalSpecialistTest = DrawnLandmarks;
using GoalBehindARobot = DrawnGoals;
using LikeAGoal = DrawnGoals;

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
            border(),
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
    boxes_ = {{{1500, hidden ? 100. : -300., 0}, {1510, 300, 300}, ColorClass::skyblue}, border()};
    look(0, 0);
    ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1) << hidden;
    const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
    EXPECT_EQ(b.leftOnBorder, hidden) << hidden;
    EXPECT_EQ(b.rightOnBorder, hidden) << hidden;
  }
}

// What hides a part of a goal may have any color, but not that of the border beside its posts.
TEST_F(GoalBehindARobot, AnEndBesideNoBorderIsNoPost) {
  for (const ColorClass color : {ColorClass::white, ColorClass::green, ColorClass::noColor}) {
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue}, border(0), border()};
    boxes_[2].color = color;
    look(0, 0);
    ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1) << enumName(color);
    const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
    EXPECT_FALSE(b.leftOnBorder) << enumName(color);
    EXPECT_EQ(b.rightOnBorder, color != ColorClass::white) << enumName(color);
  }
}

TEST_F(GoalBehindARobot, OnAFieldWithoutWallsOnlyARobotHidesAPost) {
  field_.wallHeight = 0;
  for (const ColorClass color : {ColorClass::green, ColorClass::noColor, ColorClass::gray}) {
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
              {{1490, -600, 0}, {1520, -200, 300}, color}};
    look(0, 0);
    ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1) << enumName(color);
    const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
    EXPECT_FALSE(b.leftOnBorder) << enumName(color);
    EXPECT_EQ(b.rightOnBorder, color == ColorClass::gray) << enumName(color);
  }
}

TEST_F(GoalBehindARobot, APersonAboveTheBorderDoesNotHideThePost) {
  for (const double height : {200., 40.}) {
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
              border(-2500, 2500, height),
              {{1530, -500, 0}, {1540, 0, 1200}, ColorClass::skyblue}};
    look(0, 0);
    ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1) << height;
    const ConditionalBoundary& b = percepts_.landmarks.goals[0].boundary;
    EXPECT_EQ(b.rightOnBorder, height == 40) << height;
    const double seen = b.rightOnBorder ? -510 / 1440. : -310 / 1410.;
    EXPECT_NEAR(toDegrees(b.right), toDegrees(std::atan(seen)), 1) << height;
  }
}

// A strip that one scan line meets, or two of them.
TEST_F(GoalBehindARobot, IsSeenInANarrowStrip) {
  for (int i = 0; i < 20; ++i) {
    const double y = -250 + 20 * i;
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::yellow},
              {{1400, -900, 0}, {1410, y, 300}, ColorClass::white},
              {{1400, y + 60, 0}, {1410, 900, 300}, ColorClass::white}};
    look(0, 0);
    EXPECT_EQ(percepts_.landmarks.numberOfGoals, 1) << y;
  }
}

// What hides its foot must be a robot: a shirt above something gray, or black legs, is no goal.
TEST_F(LikeAGoal, SomethingAboveAGrayOrBlackBoxIsNone) {
  for (const ColorClass color : {ColorClass::gray, ColorClass::black, ColorClass::blue}) {
    boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
              border(),
              {{600, -200, 0}, {700, 150, 170}, color}};
    look(0, 0.05);
    EXPECT_EQ(percepts_.landmarks.numberOfGoals, color == ColorClass::blue) << enumName(color);
  }
}

TEST_F(LikeAGoal, APersonInItsColorBehindAGoalIsNoPartOfIt) {
  boxes_ = {{{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
            border(),
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

// Over the length of the field it would be as low as that.
TEST_F(LikeAGoal, ASpeckOnTheFieldIsNone) {
  for (int i = 0; i < 20; ++i) {
    const double y = -200 + 17 * i;
    boxes_ = {{{1600, y, 0}, {1610, y + 25, 50}, ColorClass::yellow}};
    look(0, 0);
    EXPECT_EQ(percepts_.landmarks.numberOfGoals, 0) << y;
  }
}

// Nothing but the image's border leaves so little of a goal whose foot a robot hides.
TEST_F(LikeAGoal, APersonBehindARobotIsNoneButTheEndOfAGoalIs) {
  boxes_ = {border(),
            {{2600, -110, 0}, {2700, 110, 1200}, ColorClass::skyblue},
            {{1000, -400, 0}, {1100, 400, 265}, ColorClass::blue}};
  look(0, 0.1);
  EXPECT_EQ(percepts_.landmarks.numberOfGoals, 0);
  boxes_ = {border(),
            {{1500, -300, 0}, {1510, 300, 300}, ColorClass::skyblue},
            {{600, -700, 0}, {700, 300, 170}, ColorClass::blue}};
  const double post = std::atan2(-310, 1410), visible = fromDegrees(4);
  look(post + visible - image_.info.openingAngleX() / 2, 0);
  ASSERT_EQ(percepts_.landmarks.numberOfGoals, 1);
  EXPECT_TRUE(percepts_.landmarks.goals[0].boundary.leftOnBorder);
}

/// The front of a goal, as its size and its place ahead of a camera make it.
class LocateGoal : public testing::Test {
 protected:
  static constexpr double height = 190, depth = 300;
  FieldDimensions field_;
  CameraMatrix matrix_ = cameraAt({60, 20, height}, 0, 0, 0);
  GoalPercept goal_;

  /// At a distance at which its width, height, and how high its foot is are seen.
  bool locate(double distance, double width = 600, double goalHeight = 300, double foot = 0) {
    ConditionalBoundary& b = goal_.boundary;
    b.left = width / 2 / distance;
    b.right = -b.left;
    b.top = std::atan2(foot + goalHeight - height, distance);
    b.bottom = std::atan2(foot - height, distance);
    return locateGoal(matrix_, field_, b.leftOnBorder || b.rightOnBorder, goal_);
  }
  void cutOff(bool left, bool right, bool top, bool bottom) {
    goal_ = {};
    ConditionalBoundary& b = goal_.boundary;
    b.leftOnBorder = left;
    b.rightOnBorder = right;
    b.topOnBorder = top;
    b.bottomOnBorder = bottom;
  }
};

// The walls that are as high as they are seen are on average halfway to its back.
TEST_F(LocateGoal, ItsHeightGivesItsDistance) {
  for (const double distance : {700., 1500., 4000.}) {
    cutOff(false, false, false, false);
    ASSERT_TRUE(locate(distance)) << distance;
    const Vector2d middle{60 + distance - depth / 2, 20};
    EXPECT_NEAR(goal_.distance, middle.norm(), 1e-6);
    EXPECT_NEAR(goal_.angle, angleOf(middle), 1e-9);
    EXPECT_FALSE(goal_.boundary.leftOnBorder || goal_.boundary.rightOnBorder);
  }
}

TEST_F(LocateGoal, WithoutATopItIsInTheDirectionOfItsFoot) {
  cutOff(false, false, true, false);
  ASSERT_TRUE(locate(700));
  EXPECT_EQ(goal_.distance, 0);
  EXPECT_NEAR(goal_.angle, std::atan2(20, 60 + 700), 1e-9);
  cutOff(false, false, false, true);
  ASSERT_TRUE(locate(700));
  EXPECT_EQ(goal_.distance, 0);
  EXPECT_EQ(goal_.angle, 0) << "where the camera sees it";
}

// The camera matrix errs by 80 mm and some degrees.
TEST_F(LocateGoal, StandsOnTheGround) {
  for (const double foot : {-180., 180.}) {
    cutOff(false, false, false, false);
    EXPECT_TRUE(locate(1000, 600, 300, foot)) << foot;
    EXPECT_FALSE(locate(700, 600, 300, foot)) << foot;
    EXPECT_FALSE(locate(1000, 600, 300, 1.3 * foot)) << foot;
  }
  cutOff(false, false, true, false);
  EXPECT_TRUE(locate(1000, 600, 300, height)) << "at the horizon";
  EXPECT_FALSE(locate(1000, 600, 300, height + 40)) << "above it";
}

TEST_F(LocateGoal, IsNotMuchWiderThanAGoal) {
  cutOff(false, false, false, false);
  EXPECT_TRUE(locate(1500, 900));
  EXPECT_FALSE(locate(1500, 1000));
  EXPECT_FALSE(locate(1500, -600));
  EXPECT_FALSE(locate(1500, 600, -300));
}

// A robot hides one side of it, and nothing shows which one.
TEST_F(LocateGoal, NothingIsKnownOfTheSidesOfLessThanHalfOfIt) {
  for (const auto& [width, hidden] : {std::pair{300., false}, {240., true}}) {
    cutOff(false, false, false, false);
    ASSERT_TRUE(locate(1500, width));
    EXPECT_EQ(goal_.boundary.leftOnBorder, hidden) << width;
    EXPECT_EQ(goal_.boundary.rightOnBorder, hidden) << width;
  }
  cutOff(false, false, true, false);
  ASSERT_TRUE(locate(1500, 240));
  EXPECT_FALSE(goal_.boundary.leftOnBorder) << "its size is not known";
}

TEST_F(LocateGoal, WithAHiddenFootItIsWiderThanAFlag) {
  cutOff(false, false, false, true);
  EXPECT_TRUE(locate(1500, 200));
  EXPECT_FALSE(locate(1500, 150));
  cutOff(true, false, false, true);
  EXPECT_TRUE(locate(1500, 150)) << "cut off by the image";
  cutOff(false, true, false, true);
  EXPECT_TRUE(locate(1500, 150));
  cutOff(false, false, true, true);
  EXPECT_FALSE(locate(1500, 150)) << "at most as far away as its top says";
  matrix_.pose.translation.z() = 310;
  cutOff(false, false, false, true);
  EXPECT_TRUE(locate(1500, 150)) << "from above its distance is not known";
}

}  // namespace
}  // namespace gt
