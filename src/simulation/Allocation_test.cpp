#include <gtest/gtest.h>

#include "simulation/Simulation.h"
#include "support/TestAllocations.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// Runs to the ball and sends where it is.
class Runner : public RobotController {
 public:
  void cycle(const RobotInput& input, RobotOutput& output) override {
    const Vector2d ball = relative(input.oracle.robotPose, input.oracle.ballPosition);
    const double turn = std::clamp(0.02 * angleOf(ball), -0.01, 0.01);
    output.odometry.pose = output.odometry.pose * Pose2D{turn, 2, 0};
    output.joints.angles = standing();
    TeamMessage message;
    message.timeSent = input.now;
    output.message = message;
  }
};

TEST(Simulation, ATickAllocatesNothing) {
  SceneDescription scene = matchScene();
  scene.noise = {};
  scene.game.referee = false;
  auto made =
      Simulation::make(scene, 5, 1);  // each thread's renderer allocates with its first image
  ASSERT_TRUE(made);
  Simulation& match = **made;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) match.attach(i, std::make_unique<Runner>());
  for (int i = 0; i < 100; ++i) match.step();
  const long before = allocations();
  for (int i = 0; i < 500; ++i) match.step();
  EXPECT_EQ(allocations(), before);
  EXPECT_GE(match.world().ball(0).lastToucher, 0) << "the ball was to be touched, too";
  match.attach(0, std::make_unique<Runner>());
  EXPECT_GT(allocations(), before) << "the counter does not count";
}

}  // namespace
}  // namespace gt
