#include "modules/behavior/skills/GoToBall.h"

#include "modules/behavior/testing/SkillTest.h"

namespace gt {
namespace {

using GoToBallTest = SkillTest;

TEST_F(GoToBallTest, GoesBehindTheBallFromAllSidesWithoutTouchingIt) {
  const Vector2d ball{300, 200};
  skills.goToBall.direction = 40;
  skills.goToBall.x = 150;
  skills.goToBall.y = 20;
  for (double side = 0; side < 360; side += 30) {
    world.self.pose = {fromDegrees(2 * side), ball + direction(fromDegrees(side)) * 800};
    for (int image = 0; image < 600; ++image) {
      world.frame.time = world.frame.time + 40;
      world.ball.position = relative(world.self.pose, ball);
      world.ball.lastSeen = world.frame.time;
      cycle(skills.goToBall);
      EXPECT_GT(world.ball.position.norm(), 110) << "from " << side;
    }
    const Vector2d inRobot = relative(world.self.pose, ball);
    EXPECT_LT((inRobot - Vector2d{150, 20}).norm(), 25) << "from " << side;
    EXPECT_LT(std::abs(normalize(world.self.pose.rotation - fromDegrees(40))), fromDegrees(6))
        << "from " << side;
  }
}

}  // namespace
}  // namespace gt
