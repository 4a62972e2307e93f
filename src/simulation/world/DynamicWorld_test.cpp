#include "simulation/world/DynamicWorld.h"

#include <gtest/gtest.h>

#include "support/TestScenes.h"

namespace gt {
namespace {

SceneDescription dynamicDuel(const Pose2D& robot, const Vector2d& ball) {
  SceneDescription scene = duelScene(robot, ball);
  scene.fidelity = Fidelity::dynamic;
  return scene;
}

void run(World& world, const JointAngles& angles, int ticks) {
  const std::vector<RobotCommand> commands(world.activeRobots(), {angles, {}});
  for (int i = 0; i < ticks; ++i) world.step(commands);
}

TEST(DynamicWorld, StandsOnItsMotors) {
  const auto world = worldOf(dynamicDuel({0.5, -300, 200}, {1000, 0}));
  run(*world, firmStand(), 500);
  const RobotBody& robot = world->robot(0);
  EXPECT_EQ(robot.posture, Posture::standing);
  EXPECT_LT((robot.pose.translation - Vector2d{-300, 200}).norm(), 40);
  EXPECT_NEAR(robot.specificForce.norm(), 9810, 100);
  EXPECT_GE(std::count(robot.footOnGround.begin(), robot.footOnGround.end(), true), 3);
  // A motor gives way by some degrees under its load, and not by more.
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    EXPECT_NEAR(robot.joints.values[j], firmStand().values[j], fromDegrees(4)) << j;
}

TEST(DynamicWorld, ServosWorkWithTheGainsOfTheirCommands) {
  const auto world = worldOf(dynamicDuel({0.5, -300, 200}, {1000, 0}));
  run(*world, firmStand(), 250);
  const double firm = world->robot(0).height;
  RobotCommand soft{firmStand(), {}};
  for (PidGains& gains : soft.gains.gains.values) gains = {0, 0, gains.d};
  for (int i = 0; i < 500; ++i) world->step({&soft, 1});
  EXPECT_LT(world->robot(0).height, firm - 15) << "the legs give way";
  run(*world, firmStand(), 250);
  EXPECT_NEAR(world->robot(0).height, firm, 5) << "as recommended again";
}

TEST(DynamicWorld, IsPutDownOnceItsLegsAreWhereTheyShallBe) {
  const auto world = worldOf(dynamicDuel({0.5, -300, 200}, {1000, 0}));
  // Slowly from the straight legs with which it was switched on, as DefaultMotionControl does it.
  for (int i = 1; i <= 100; ++i) {
    JointAngles angles;
    for (std::size_t j = 0; j < enumCount<Joint>; ++j)
      angles.values[j] = firmStand().values[j] * i / 100;
    run(*world, angles, 1);
    ASSERT_NEAR(world->robot(0).tilt, 0, 0.01) << i;
  }
  run(*world, firmStand(), 400);
  EXPECT_EQ(world->robot(0).posture, Posture::standing);
  EXPECT_LT((world->robot(0).pose.translation - Vector2d{-300, 200}).norm(), 40);
}

TEST(DynamicWorld, IsHeldUntilItsLegsRestWhereverItIsPut) {
  for (const int tick : {0, 20, 40, 60, 200}) {
    const auto world = worldOf(dynamicDuel({0.5, -300, 200}, {1000, 0}));
    run(*world, firmStand(), tick);
    world->placeRobot(0, {0, 300, -200});
    run(*world, firmStand(), 500);
    EXPECT_EQ(world->robot(0).posture, Posture::standing) << tick;
    EXPECT_LT((world->robot(0).pose.translation - Vector2d{300, -200}).norm(), 40) << tick;
  }
}

TEST(DynamicWorld, WhatARobotBelievesToWalkMovesNothing) {
  const auto world = worldOf(dynamicDuel({}, {1000, 0}));
  run(*world, firmStand(), 250);
  const Vector2d before = world->robot(0).pose.translation;
  const RobotCommand command{firmStand(), Pose2D{0, 2, 0}};
  for (int i = 0; i < 125; ++i) world->step({&command, 1});
  EXPECT_LT((world->robot(0).pose.translation - before).norm(), 3);
}

TEST(DynamicWorld, AThrownRobotFeelsItsSide) {
  const auto world = worldOf(dynamicDuel({}, {1000, 0}));
  run(*world, firmStand(), 250);
  world->throwOver(0, Posture::onLeftSide);
  run(*world, firmStand(), 250);
  EXPECT_EQ(world->robot(0).posture, Posture::onLeftSide);
  EXPECT_LT(world->robot(0).specificForce.y(), -8500);  // the ground pushes from the left
  EXPECT_LT(world->robot(0).height, 90);
  world->standUp(0);
  run(*world, firmStand(), 250);
  EXPECT_EQ(world->robot(0).posture, Posture::standing);
  EXPECT_GT(world->robot(0).specificForce.z(), 9500);
}

TEST(DynamicWorld, ARobotPushedOverItsFeetFalls) {
  const auto world = worldOf(dynamicDuel({}, {1000, 0}));
  run(*world, firmStand(), 250);
  JointAngles leaning = firmStand();
  for (const Leg leg : {Leg::foreRight, Leg::hindRight}) leaning[legJoint(leg, 3)] = 2.5;
  for (const Leg leg : {Leg::foreLeft, Leg::hindLeft}) leaning[legJoint(leg, 2)] = -0.19;
  double most = 0;
  for (int i = 0; i < 250; ++i) {
    run(*world, leaning, 1);
    most = std::max(most, world->robot(0).roll);
  }
  EXPECT_GT(most, fromDegrees(15));  // to its right side
}

TEST(DynamicWorld, APushMovesABodyByItsImpulse) {
  const auto world = worldOf(dynamicDuel({0, 0, 0}, {1000, 800}));
  run(*world, firmStand(), 100);
  const auto speedAfter = [&](const Vector3d& force) {
    const Vector2d before = world->robot(0).pose.translation;
    world->push(0, force, {0, 0, 0});
    run(*world, firmStand(), 1);
    const Vector2d moved = world->robot(0).pose.translation - before;
    run(*world, firmStand(), 100);
    return Vector2d{moved / tickSeconds};
  };
  EXPECT_NEAR(speedAfter({0, 0, 0}).norm(), 0, 2);
  EXPECT_GT(speedAfter({0, 20, 0}).y(), 20);  // 0.16 N s on a robot of 1.4 kg whose feet hold it
  EXPECT_LT(speedAfter({0, 20, 0}).y(), 160);
  EXPECT_LT(speedAfter({-20, 0, 0}).x(), -20);
}

TEST(DynamicWorld, AWallThatWasMovedIsWhereItWasMovedTo) {
  const auto world = worldOf(dynamicDuel({0, 0, 0}, {600, 0}));
  const int wall = mj_name2id(&world->model(), mjOBJ_GEOM, "wallLeft");
  ASSERT_GE(wall, 0);
  world->placeRobot(0, {0, -1500, -800});
  world->placeBall(0, {600, 0}, {0, 1000});
  world->moveGeom(wall, {600, 300, 50});
  run(*world, firmStand(), 100);
  EXPECT_LT(world->ball(0).position.y(), 300);
}

TEST(DynamicWorld, ABallRollsOutAndBounces) {
  const auto world = worldOf(dynamicDuel({0, -1500, -800}, {0, 0}));
  const double deceleration = matchScene().physics.deceleration;
  world->placeBall(0, {-1000, 500}, {800, 0});
  run(*world, firmStand(), 125);
  EXPECT_NEAR(world->ball(0).speed.x(), 800 - deceleration, 0.12 * deceleration);
  EXPECT_NEAR(world->ball(0).position.x(), -1000 + 800 - deceleration / 2, 30);
  world->placeBall(0, {0, 1000}, {0, 1200});
  run(*world, firmStand(), 60);
  EXPECT_LT(world->ball(0).speed.y(), -50);
  run(*world, firmStand(), 1000);
  EXPECT_LT(world->ball(0).speed.norm(), 20);
  EXPECT_LT(std::abs(world->ball(0).position.y()), 1310);
}

TEST(DynamicWorld, ABallRollsOnAsItIsPutHoweverItLay) {
  const auto world = worldOf(dynamicDuel({0, -1500, -800}, {0, 0}));
  for (const Vector2d& before : {Vector2d{0, 0}, Vector2d{700, 200}, Vector2d{-300, 900}}) {
    world->placeBall(0, {0, 0}, before);
    run(*world, firmStand(), 100);
    world->placeBall(0, {-1000, 0}, {1000, 0});
    run(*world, firmStand(), 125);
    const Vector2d expected{-1000 + 1000 - matchScene().physics.deceleration / 2, 0};
    EXPECT_LT((world->ball(0).position - expected).norm(), 30) << before.transpose();
  }
}

TEST(DynamicWorld, ABallThatIsPutTooFastBeginsThereAsFastAsABallMayBe) {
  const auto world = worldOf(dynamicDuel({0, -1500, -800}, {-500, 700}));
  const double fastest = matchScene().physics.maxSpeed;
  run(*world, firmStand(), 10);
  for (const double speed : {1., 2., 10.}) {
    world->placeBall(0, {0, -700}, {0, speed * fastest});
    run(*world, firmStand(), 1);
    EXPECT_NEAR(world->ball(0).speed.norm(), fastest, 0.02 * fastest) << speed;
    EXPECT_LT((world->ball(0).position - Vector2d{0, -700 + fastest * tickSeconds}).norm(), 5);
  }
}

TEST(DynamicWorld, LegsMoveTheBallAndAreRemembered) {
  const auto world = worldOf(dynamicDuel({}, {180, -60}));
  run(*world, firmStand(), 250);
  world->placeBall(0, {150, -60});
  JointAngles kick = firmStand();
  kick[Joint::legFR1] = fromDegrees(60);
  kick[Joint::legFR3] = 0;
  run(*world, kick, 60);
  EXPECT_GT(world->ball(0).position.x(), 160);
  EXPECT_EQ(world->ball(0).lastToucher, 0);
}

/// The angle by which a fore knee gives way under a standing robot (rad).
double kneeGivesWay(const DynamicsParameters& dynamics) {
  SceneDescription scene = dynamicDuel({}, {1000, 0});
  scene.dynamics = dynamics;
  const auto world = worldOf(scene);
  run(*world, firmStand(), 500);
  return world->robot(0).joints[Joint::legFR3] - firmStand()[Joint::legFR3];
}

TEST(DynamicWorld, HeavyAndWeakRobotsGiveWayMore) {
  const double usual = kneeGivesWay({});
  ASSERT_GT(std::abs(usual), 0.001);
  EXPECT_GT(std::abs(kneeGivesWay({.mass = 1.3})), 1.1 * std::abs(usual));
  EXPECT_GT(std::abs(kneeGivesWay({.strength = 0.7})), 1.1 * std::abs(usual));
}

TEST(DynamicWorld, OnIceTheFeetSlip) {
  const auto moves = [](double friction) {
    SceneDescription scene = dynamicDuel({}, {1000, 0});
    const auto world = worldOf(scene);
    run(*world, firmStand(), 250);
    scene.dynamics.friction = friction;
    world->change(scene);
    JointAngles push = firmStand();  // ahead, with all legs
    for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
      push[legJoint(leg, 1)] += isFore(leg) ? -0.4 : 0.4;
    const Vector2d before = world->robot(0).pose.translation;
    run(*world, push, 30);
    return world->robot(0).pose.translation.x() - before.x();
  };
  EXPECT_GT(moves(1), 15);
  EXPECT_LT(moves(0.1), 0.9 * moves(1));
}

TEST(DynamicWorld, SurvivesAnything) {
  SceneDescription scene = matchScene();
  scene.fidelity = Fidelity::dynamic;
  const auto world = worldOf(scene);
  Random random{5};
  std::vector<RobotCommand> commands(world->activeRobots());
  for (int i = 0; i < 1500; ++i) {
    if (i % 40 == 0)
      for (RobotCommand& command : commands) {
        command.joints = randomAngles(random);
        if (random.uniform() < 0.1) command.joints.values.fill(std::nan(""));
      }
    if (i % 100 == 0) world->placeRobot(i / 100 % 8, {random.uniform(-3, 3), 0, 0});
    if (i % 250 == 0) world->throwOver(i / 250 % 8, Posture::onRightSide);
    world->step(commands);
    for (std::size_t r = 0; r < world->robotCount(); ++r) {
      const RobotBody& robot = world->robot(r);
      ASSERT_TRUE(robot.pose.translation.allFinite()) << i;
      ASSERT_GT(robot.height, 10) << i;
      ASSERT_LT(robot.height, 450) << i;
      ASSERT_LT(std::abs(robot.pose.translation.x()), 2500) << i;
      ASSERT_LT(std::abs(robot.pose.translation.y()), 1500) << i;
    }
    ASSERT_TRUE(world->ball(0).position.allFinite());
  }
}

TEST(DynamicWorld, TheSameCommandsGiveTheSameBits) {
  const auto one = worldOf(dynamicDuel({}, {200, 0}), 1);
  const auto other = worldOf(dynamicDuel({}, {200, 0}), 2);  // nothing in it is left to chance
  Random random{6};
  for (int i = 0; i < 20; ++i) {
    const JointAngles angles = randomAngles(random);
    run(*one, angles, 25);
    run(*other, angles, 25);
    ASSERT_EQ(one->robot(0).joints.values, other->robot(0).joints.values);
    ASSERT_EQ(one->ball(0).position, other->ball(0).position);
  }
}

}  // namespace
}  // namespace gt
