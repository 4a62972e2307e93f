#include "modules/behavior/skills/GoToPoint.h"

#include "base/Random.h"
#include "modules/behavior/testing/SkillTest.h"

namespace gt {
namespace {

class GoToPointTest : public SkillTest {
 protected:
  /// Angle in degrees.
  void setGoal(const Vector2d& goal, double angle) {
    skills.goToPoint.x = goal.x();
    skills.goToPoint.y = goal.y();
    skills.goToPoint.angle = angle;
    skills.goToPoint.maxSpeed = 200;
  }
};

TEST_F(GoToPointTest, ArrivesFromAnywhere) {
  Random random{5};
  for (int i = 0; i < 50; ++i) {
    world.self.pose = {random.uniform(-3, 3), random.uniform(-2000, 2000),
                       random.uniform(-1300, 1300)};
    const Vector2d goal{random.uniform(-2000, 2000), random.uniform(-1300, 1300)};
    const double angle = random.uniform(-180, 180);
    setGoal(goal, angle);
    for (int image = 0; image < 1500; ++image) cycle(skills.goToPoint);
    EXPECT_EQ(request.type, MotionType::stand);
    EXPECT_LT((world.self.pose.translation - goal).norm(), 25);
    EXPECT_LT(std::abs(normalize(world.self.pose.rotation - fromDegrees(angle))), fromDegrees(4));
    world.self.pose = world.self.pose * Pose2D{fromDegrees(3), 20, 20};
    cycle(skills.goToPoint);
    EXPECT_EQ(request.type, MotionType::stand) << "a small drift";
  }
}

TEST_F(GoToPointTest, KeepsClearOfTeammates) {
  const Vector2d mate{0, 60};
  world.players.ownTeam = {{mate, world.frame.time, 0.9, 4}};
  world.self.pose = {0, -1500, 0};
  double nearest = 1e9;
  setGoal({1500, 0}, 0);
  for (int image = 0; image < 1500; ++image) {
    cycle(skills.goToPoint);
    nearest = std::min(nearest, (world.self.pose.translation - mate).norm());
  }
  EXPECT_GT(nearest, 150);
  EXPECT_LT((world.self.pose.translation - Vector2d{1500, 0}).norm(), 100);
}

}  // namespace
}  // namespace gt
