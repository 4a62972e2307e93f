#include "modules/behavior/skills/Movement.h"

#include <array>
#include <cmath>

#include "modules/behavior/testing/SkillTest.h"

namespace gt {
namespace {

using MovementTest = SkillTest;

TEST_F(MovementTest, LimitsSpeeds) {
  movement.walk({1000, -1000}, 20);
  EXPECT_EQ(request.type, MotionType::walk);
  EXPECT_DOUBLE_EQ(request.walk.translation.x(), parameters.maxForward);
  EXPECT_DOUBLE_EQ(request.walk.translation.y(), -parameters.maxSideways);
  EXPECT_DOUBLE_EQ(request.walk.rotation, fromDegrees(parameters.maxTurn));
}

TEST_F(MovementTest, IsFasterSidewaysAndInTurnsWithTheWalkTypeFast) {
  manner.type = WalkType::fast;
  movement.walk({-1000, 1000}, -20);
  EXPECT_DOUBLE_EQ(request.walk.translation.x(), -parameters.fastSideways);
  EXPECT_DOUBLE_EQ(request.walk.translation.y(), parameters.fastSideways);
  EXPECT_DOUBLE_EQ(request.walk.rotation, -fromDegrees(parameters.fastTurn));
}

TEST_F(MovementTest, ApproachesInTheDirectionOfItsGoalAndEverSlower) {
  const WorldState state = world.state();
  tactics.update(state);
  double last = 1e9;
  for (const double distance : {1000., 100., 50., 10.}) {
    movement.approach(Vector2d{2, 1}.normalized() * distance, 0, 200);
    const Vector2d speed = request.walk.translation;
    EXPECT_NEAR(speed.x(), 2 * speed.y(), 1e-9);
    EXPECT_LE(speed.norm(), last);
    EXPECT_GT(speed.norm(), 30);
    last = speed.norm();
  }
}

TEST_F(MovementTest, DoesNotWalkIntoARobot) {
  world.players.opponents = {{{280, 0}, world.frame.time, 1, 0}};
  const WorldState state = world.state();
  tactics.update(state);
  movement.approach({1000, 0}, 0, 200);
  EXPECT_LT(request.walk.translation.x(), 25);
  movement.approach({-1000, 0}, 0, 200);
  EXPECT_LT(request.walk.translation.x(), -100);
}

TEST_F(MovementTest, GivesWay) {
  world.players.opponents = {{{0, 300}, world.frame.time, 1, 0}};
  const WorldState state = world.state();
  tactics.update(state);
  movement.approach({0, 1000}, 0, 200);
  EXPECT_GT(request.walk.translation.y(), 20) << "who does not give way goes near";
  manner.giveWay = true;
  movement.approach({0, 1000}, 0, 200);
  EXPECT_LT(request.walk.translation.y(), -150) << "who does steps back";
  movement.approach({-1000, 1000}, 0, 200);
  EXPECT_LT(request.walk.translation.x(), -60) << "and goes past";
}

// Two robots that want to the same place push each other, though neither sees the other one.
TEST_F(MovementTest, StepsBackFromWhatHoldsItsLegsUpForLong) {
  const auto walkFor = [&](int images, bool isHeldUp) {
    for (int image = 0; image < images; ++image) {
      world.frame.time = world.frame.time + 40;
      if (isHeldUp) world.collision.lastCollision = world.frame.time - 8;
      const WorldState state = world.state();
      tactics.update(state);
      movement.walk({120, 90}, 0.5);
    }
    return request.walk.translation;
  };
  manner.endPushes = true;
  EXPECT_GT(walkFor(30, true).x(), 100) << "1.2 s";
  EXPECT_GT(walkFor(20, false).x(), 100) << "it came free";
  EXPECT_GT(walkFor(30, true).x(), 100) << "a push of its own";
  const Vector2d back = walkFor(10, true);
  EXPECT_NEAR(back.x(), -160, 1) << "against where it wanted to go";
  EXPECT_NEAR(back.y(), -120, 1);
  EXPECT_EQ(request.walk.rotation, 0.5);
  EXPECT_GT(walkFor(20, false).x(), 100) << "after 0.7 s";
  manner.endPushes = false;
  EXPECT_GT(walkFor(100, true).x(), 100) << "only who shall end pushes";
}

// Whatever a robot does that keeps off its own penalty area: it does not enter it.
TEST_F(MovementTest, KeepsOffTheOwnPenaltyArea) {
  manner = {WalkType::fast, true};
  const auto isInside = [&] {
    const Vector2d place = world.self.pose.translation;
    return place.x() < -world.field.xPenaltyArea && std::abs(place.y()) < world.field.yPenaltyArea;
  };
  const std::array<Vector2d, 7> places{
      {{-1800, -700}, {-1800, 700}, {-1900, 0}, {-1300, 0}, {-1700, 400}, {-1400, -650}, {0, 0}}};
  for (const Vector2d& from : {places[0], places[1], places[3], places[5]})
    for (const Vector2d& to : places) {
      world.self.pose = {1, from};
      skills.goToPoint.x = to.x();
      skills.goToPoint.y = to.y();
      for (int image = 0; image < 700; ++image) {
        cycle(skills.goToPoint);
        ASSERT_FALSE(isInside()) << from.transpose() << " to " << to.transpose();
      }
      const bool isAllowed =
          to.x() > -world.field.xPenaltyArea || std::abs(to.y()) > world.field.yPenaltyArea;
      if (!isAllowed) continue;
      EXPECT_LT((world.self.pose.translation - to).norm(), 60)
          << from.transpose() << " to " << to.transpose();
    }
}

TEST_F(MovementTest, LeavesTheOwnPenaltyArea) {
  manner.keepOffOwnArea = true;
  for (const Vector2d& from : {Vector2d{-1700, 0}, Vector2d{-2000, 400}, Vector2d{-2000, -400}}) {
    world.self.pose = {2, from};
    for (int image = 0; image < 100; ++image) {
      const WorldState state = world.state();
      tactics.update(state);
      movement.walk({0, 0}, 0);
      world.self.pose = world.self.pose * Pose2D{0, request.walk.translation * 0.04};
    }
    const Vector2d& place = world.self.pose.translation;
    EXPECT_TRUE(place.x() > -world.field.xPenaltyArea ||
                std::abs(place.y()) > world.field.yPenaltyArea)
        << from.transpose();
  }
}

TEST_F(MovementTest, AGoalieWalksInItsPenaltyArea) {
  world.self.pose = {0, -1500, 0};
  const WorldState state = world.state();
  tactics.update(state);
  movement.approach({-300, 0}, 0, 200);
  EXPECT_LT(request.walk.translation.x(), -100);
}

TEST_F(MovementTest, ARequestOfOneKindLeavesNothingOfTheLast) {
  world.motions.motions = {{}, {"someKick", {}}};
  const WorldState state = world.state();
  tactics.update(state);
  movement.walk({100, 0}, 0);
  movement.perform(SpecialAction{1});
  EXPECT_EQ(request.type, MotionType::specialAction);
  EXPECT_EQ(request.specialAction, "someKick");
  EXPECT_EQ(request.walk.translation.x(), 0);
  movement.getup();
  EXPECT_EQ(request.type, MotionType::getup);
  EXPECT_EQ(request.specialAction, "");
  movement.perform(SpecialAction{7});
  EXPECT_EQ(request.specialAction, "") << "there is none of this index";
}

}  // namespace
}  // namespace gt
