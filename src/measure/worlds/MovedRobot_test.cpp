#include "measure/worlds/MovedRobot.h"

#include <gtest/gtest.h>

#include "support/TestScenes.h"

namespace gt {
namespace {

std::unique_ptr<MovedRobot> moved(Fidelity fidelity) {
  SceneDescription scene = matchScene();
  scene.fidelity = fidelity;
  scene.game.referee = false;
  scene.robots.resize(1);
  scene.robots.front().x = 0;
  auto robot = MovedRobot::make(DataRoot{}, scene, 1);
  EXPECT_TRUE(robot) << robot.error().text();
  return *std::move(robot);
}

TEST(MovedRobot, DoesWhatIsRequestedInBothFidelities) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
    const auto robot = moved(fidelity);
    robot->standUp();
    robot->run(1);
    EXPECT_FALSE(robot->hasFallen());
    const Vector2d start = robot->body().pose.translation;
    EXPECT_LT(start.norm(), 40);
    robot->head.pan = 0.5;
    robot->request.type = MotionType::walk;
    robot->request.walk = {0, 100, 0};
    robot->run(3);
    EXPECT_GT(robot->body().pose.translation.x() - start.x(), 80);
    EXPECT_NEAR(robot->body().joints[Joint::headPan], 0.5, 0.05);
    EXPECT_EQ(robot->motion().executed.type, MotionType::walk);
    EXPECT_GT(robot->odometry().pose.translation.x(), 200);
    robot->request = {};
    robot->request.type = MotionType::specialAction;
    robot->request.specialAction = "sit";
    robot->run(2);
    EXPECT_EQ(robot->motion().executed.specialAction, "sit");
  }
}

TEST(MovedRobot, GetsUpFromEveryPosture) {
  const auto robot = moved(Fidelity::dynamic);
  robot->standUp();
  robot->request.type = MotionType::getup;
  for (const Posture posture : {Posture::onLeftSide, Posture::onRightSide, Posture::onNose,
                                Posture::onBack, Posture::sitting}) {
    robot->world().throwOver(0, posture);
    robot->run(6);
    EXPECT_FALSE(robot->hasFallen()) << enumName(posture);
    EXPECT_GT(robot->body().height, 90) << enumName(posture);
    EXPECT_EQ(robot->motion().executed.specialAction, "") << enumName(posture);
  }
}

TEST(MovedRobot, TakesParametersAndRefusesWrongOnes) {
  const auto robot = moved(Fidelity::kinematic);
  EXPECT_TRUE(robot->configure("WalkingEngine", "InvKin", "[normal]\nmaxStepSizeX 4"));
  robot->standUp();
  robot->request.type = MotionType::walk;
  robot->request.walk = {0, 1000, 0};
  robot->run(2);
  EXPECT_LT(robot->motion().executed.walk.translation.x(), 80);
  EXPECT_EQ(robot->configure("WalkingEngine", "InvKin", "stepLan 5").error().field, "stepLan");
  EXPECT_EQ(robot->configure("BallLocator", "PIDSmoothed", "").error().field, "BallLocator");
}

}  // namespace
}  // namespace gt
