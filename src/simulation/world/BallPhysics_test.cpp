#include "simulation/world/BallPhysics.h"

#include <gtest/gtest.h>

#include "support/TestScenes.h"

namespace gt {
namespace {

/// As low as in walking: legs spread so that chest and head reach the ball.
RobotCommand crouching(const Pose2D& step = {}) {
  RobotCommand command = standingCommand(step);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    command.joints[legJoint(leg, 2)] = fromDegrees(50);
  return command;
}

TEST(BallPhysics, RollsToRest) {
  SceneDescription scene = duelScene({0, -2000, 0}, {-1500, 300});
  for (const double deceleration : {150., 250., 600.})
    for (const double speed : {200., 500., 900.}) {
      scene.physics.deceleration = deceleration;
      const auto world = worldOf(scene);
      world->placeBall(0, {-1500, 300}, rotated({speed, 0}, 0.2));
      run(*world, standingCommand(), 1500);
      const double way = (world->ball(0).position - Vector2d{-1500, 300}).norm();
      EXPECT_EQ(world->ball(0).speed.norm(), 0);
      EXPECT_NEAR(way, speed * speed / 2 / deceleration, speed * tickSeconds);
    }
}

TEST(BallPhysics, BouncesOffTheWall) {
  SceneDescription scene = duelScene({0, -2000, 0}, {0, 0});
  scene.physics.deceleration = 0;
  scene.physics.friction = 0;
  const auto world = worldOf(scene);
  world->placeBall(0, {500, 1000}, {300, 800});
  run(*world, standingCommand(), 100);
  EXPECT_NEAR(world->ball(0).speed.x(), 300, 1e-9);
  EXPECT_NEAR(world->ball(0).speed.y(), -800 * scene.physics.bounceWall, 1e-9);
  // It turned round where its rim met the wall.
  const double reached = 1350 - 43;
  const double late = 0.8 - (reached - 1000) / 800;
  EXPECT_NEAR(world->ball(0).position.y(), reached - 400 * late, 8);
}

TEST(BallPhysics, ItTurnsAsItRolls) {
  const auto world = worldOf(duelScene({0, -2000, 0}, {0, 0}));
  world->placeBall(0, {0, 0}, {400, 0});
  const mjtNum* rotation = world->data().qpos + world->model().nq - 4;
  run(*world, standingCommand(), 25);
  const double angle = 2 * std::atan2(rotation[2], rotation[0]);
  EXPECT_NEAR(angle, world->ball(0).position.x() / world->ballRadius(0), 1e-6);
  EXPECT_NEAR(rotation[1], 0, 1e-9);
}

TEST(BallPhysics, AWalkingRobotPushesIt) {
  const auto world = worldOf(duelScene({0, -400, 0}, {0, 0}));
  run(*world, crouching({0, 1.6, 0}), 300);
  EXPECT_GT(world->ball(0).position.x(), 100);
  EXPECT_EQ(world->ball(0).lastToucher, 0);
  EXPECT_LE(world->ball(0).lastTouched, world->time());
}

TEST(BallPhysics, AStandingRobotsChestIsTooLowForItToPassBelow) {
  RobotCommand command = standingCommand({0, 1.2, 0});
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    command.joints[legJoint(leg, 1)] = isFore(leg) ? -0.726 : -0.799;  // motions/postures/stand.mof
    command.joints[legJoint(leg, 2)] = 0.32;
    command.joints[legJoint(leg, 3)] = isFore(leg) ? 1.729 : 1.888;
  }
  for (const double y : {-40., 0., 20., 60.}) {
    const auto world = worldOf(duelScene({0, -1000, 0}, {-600, y}));
    run(*world, command, 600);
    const Vector2d ball = relative(world->robot(0).pose, world->ball(0).position);
    EXPECT_GT(ball.x(), 60) << y;
    EXPECT_LT(ball.norm(), 300) << y;
  }
}

TEST(BallPhysics, ASwingingLegKicksAndTheSpeedIsThatOfTheLeg) {
  const Pose2D pose{0, 0, 0};
  const auto world = worldOf(duelScene(pose, {1000, 1000}));
  RobotCommand command = standingCommand();
  command.joints[Joint::legFL3] = fromDegrees(60);
  run(*world, command, 150);
  // The ball before the left fore foot; the leg swings forward.
  const int foot = world->parts(0).footSites[1];
  const Vector3d at = fromMuJoCo(world->data().site_xpos + 3 * foot);
  const Vector2d ball{at.x() + 14 + 43 + 5, at.y()};
  world->placeBall(0, ball);
  run(*world, command, 50);
  EXPECT_EQ(world->ball(0).position, ball);
  EXPECT_EQ(world->ball(0).lastToucher, -1);
  command.joints[Joint::legFL1] = fromDegrees(60);
  double fastestFoot = 0, fastestBall = 0;
  Vector3d before = at;
  for (int i = 0; i < 40; ++i) {
    run(*world, command, 1);
    const Vector3d now = fromMuJoCo(world->data().site_xpos + 3 * foot);
    fastestFoot = std::max(fastestFoot, (now - before).x() / tickSeconds);
    before = now;
    fastestBall = std::max(fastestBall, world->ball(0).speed.norm());
  }
  EXPECT_GT(fastestBall, 200);
  EXPECT_GT(fastestFoot, 150);
  EXPECT_LT(fastestBall, 1.6 * fastestFoot);
  EXPECT_EQ(world->ball(0).lastToucher, 0);
  EXPECT_GT(world->ball(0).position.x(), ball.x() + 20);
}

TEST(BallPhysics, ASwingingHeadKicks) {
  const auto world = worldOf(duelScene({0, 0, 0}, {1000, 1000}));
  RobotCommand command = crouching();
  command.joints[Joint::headTilt] = fromDegrees(-75);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft})
    command.joints[legJoint(leg, 2)] = fromDegrees(70);
  run(*world, command, 150);
  const int camera = world->parts(0).cameraSite;
  const Vector3d nose = fromMuJoCo(world->data().site_xpos + 3 * camera);
  ASSERT_LT(nose.z(), 80);
  world->placeBall(0, {nose.x() - 5, 43 + 22});
  command.joints[Joint::headPan] = fromDegrees(80);
  run(*world, command, 40);
  EXPECT_EQ(world->ball(0).lastToucher, 0);
  EXPECT_GT(world->ball(0).position.y(), 43 + 30);
}

TEST(BallPhysics, ARobotThatIsPutBesideItDoesNotKick) {
  const auto world = worldOf(duelScene({0, -1000, 0}, {0, 0}));
  run(*world, standingCommand(), 100);
  world->placeRobot(0, {0, -130, 0});
  run(*world, standingCommand(), 2);
  EXPECT_LT(world->ball(0).speed.norm(), 1);
}

bool inside(const Vector2d& p) {
  const double x = std::abs(p.x()), y = std::abs(p.y()), r = 43 - 0.01;
  const bool onField = x <= 2100 - r && y <= 1350 - r;
  const bool inGoal = x <= 2400 - r && y <= 300 - r;
  const bool atPost = y <= 300 && x <= 2100;  // between the posts, round a post's edge
  const bool slope = x + y <= 3150 - r * std::sqrt(2.) || !onField;
  return (onField || inGoal || atPost) && slope;
}

TEST(BallPhysics, StaysInsideAmongRandomRobots) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SceneDescription scene = matchScene();
    scene.noise = {};
    scene.physics.deceleration = 30;
    const auto world = worldOf(scene, seed);
    Random random{seed};
    std::vector<RobotCommand> commands(8, standingCommand());
    double fastest = 0;
    for (int tick = 0; tick < 10'000; ++tick) {
      if (tick % 40 == 0)
        for (std::size_t i = 0; i < commands.size(); ++i) {
          // They run at the ball, and throw their legs about.
          const Vector2d toBall = relative(world->robot(i).pose, world->ball(0).position);
          commands[i] = {randomAngles(random), {0.05 * angleOf(toBall), 4 * random.uniform(), 0}};
        }
      if (tick % 500 == 0)
        world->placeBall(0, {1500 * random.symmetric(), 900 * random.symmetric()},
                         3000 * direction(random.uniform(-pi, pi)));
      const Vector2d before = world->ball(0).position;
      world->step(commands);
      const BallState& ball = world->ball(0);
      ASSERT_TRUE(ball.position.allFinite() && ball.speed.allFinite());
      ASSERT_LE(ball.speed.norm(), scene.physics.maxSpeed + 1e-6);
      ASSERT_TRUE(inside(ball.position))
          << "seed " << seed << " tick " << tick << " at " << ball.position.transpose();
      ASSERT_LT((ball.position - before).norm(), 80);
      fastest = std::max(fastest, ball.speed.norm());
    }
    EXPECT_GT(fastest, 1000);
  }
}

TEST(BallPhysics, SqueezedBetweenTwoRobotsItGetsOut) {
  SceneDescription scene = matchScene();
  scene.robots.resize(2);
  scene.robots[0].x = -400;
  scene.robots[0].y = 0;
  scene.robots[1] = scene.robots[0];
  scene.robots[1].name = "other";
  scene.robots[1].x = 400;
  scene.robots[1].rotation = 180;
  const auto world = worldOf(scene);
  const std::vector<RobotCommand> commands(2, standingCommand({0, 1, 0}));
  for (int i = 0; i < 600; ++i) {
    world->step(commands);
    ASSERT_TRUE(world->ball(0).position.allFinite());
    ASSERT_LT(world->ball(0).speed.norm(), 1500);
  }
}

}  // namespace
}  // namespace gt
