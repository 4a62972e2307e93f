#include "modules/behavior/skills/Movement.h"

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
  walkType = WalkType::fast;
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
