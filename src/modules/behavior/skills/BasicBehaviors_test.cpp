#include "modules/behavior/skills/BasicBehaviors.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

class BasicBehaviorsTest : public ::testing::Test {
 protected:
  /// Moves the robot as it asks for, for one picture.
  void move() {
    if (request.type == MotionType::walk)
      world.self.pose =
          world.self.pose * Pose2D{request.walk.rotation * 0.04, request.walk.translation * 0.04};
  }
  /// Angle in degrees.
  void goTo(const Vector2d& goal, double angle) {
    skills.goToPoint.x = goal.x();
    skills.goToPoint.y = goal.y();
    skills.goToPoint.angle = angle;
    skills.goToPoint.maxSpeed = 200;
  }
  WorldState world;
  MotionRequest request;
  Movement::Parameters parameters;
  Movement movement{world, request, parameters};
  BasicBehaviors skills{movement};
};

TEST_F(BasicBehaviorsTest, LimitsSpeeds) {
  skills.walk.x = 1000;
  skills.walk.y = -1000;
  skills.walk.turn = 1000;
  skills.walk.execute();
  EXPECT_EQ(request.type, MotionType::walk);
  EXPECT_DOUBLE_EQ(request.walk.translation.x(), parameters.maxForward);
  EXPECT_DOUBLE_EQ(request.walk.translation.y(), -parameters.maxSideways);
  EXPECT_DOUBLE_EQ(request.walk.rotation, fromDegrees(parameters.maxTurn));
}

TEST_F(BasicBehaviorsTest, GoToPointArrivesFromAnywhere) {
  Random random{5};
  for (int i = 0; i < 50; ++i) {
    world.self.pose = {random.uniform(-3, 3), random.uniform(-2000, 2000),
                       random.uniform(-1300, 1300)};
    const Vector2d goal{random.uniform(-2000, 2000), random.uniform(-1300, 1300)};
    const double angle = random.uniform(-180, 180);
    goTo(goal, angle);
    for (int cycle = 0; cycle < 1500; ++cycle) {
      skills.goToPoint.execute();
      move();
    }
    EXPECT_EQ(request.type, MotionType::stand);
    EXPECT_LT((world.self.pose.translation - goal).norm(), 25);
    EXPECT_LT(std::abs(normalize(world.self.pose.rotation - fromDegrees(angle))), fromDegrees(4));
    world.self.pose = world.self.pose * Pose2D{fromDegrees(3), 20, 20};
    skills.goToPoint.execute();
    EXPECT_EQ(request.type, MotionType::stand) << "a small drift";
  }
}

TEST_F(BasicBehaviorsTest, GoToPointKeepsClearOfMates) {
  const Vector2d mate{0, 60};
  world.players.ownTeam = {{mate, world.now, 0.9, 4}};
  world.self.pose = {0, -1500, 0};
  double nearest = 1e9;
  goTo({1500, 0}, 0);
  for (int cycle = 0; cycle < 1500; ++cycle) {
    world.obstacles = {};
    world.addMatesToObstacles();
    skills.goToPoint.execute();
    move();
    nearest = std::min(nearest, (world.self.pose.translation - mate).norm());
  }
  EXPECT_GT(nearest, 150);
  EXPECT_LT((world.self.pose.translation - Vector2d{1500, 0}).norm(), 100);
}

}  // namespace
}  // namespace gt
