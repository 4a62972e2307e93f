#include "simulation/world/World.h"

#include <gtest/gtest.h>

#include "representations/infrastructure/RobotFootprint.h"
#include "representations/motion/KickTable.h"
#include "simulation/world/Servo.h"
#include "simulation/world/Stance.h"
#include "streams/Config.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

TEST(World, RobotsWalkByTheirOwnMotionModel) {
  const auto world = worldOf(duelScene({pi / 2, -500, -300}, {2000, 1000}));
  run(*world, standingCommand({0, 1.5, 0.5}), 200);
  EXPECT_LT((world->robot(0).pose.translation - Vector2d{-600, 0}).norm(), 1e-6);
  EXPECT_NEAR(world->robot(0).walked, 200 * std::hypot(1.5, 0.5), 1e-6);
  run(*world, standingCommand({0.01, 0, 0}), 100);
  EXPECT_NEAR(world->robot(0).pose.rotation, pi / 2 + 1, 1e-9);
}

TEST(World, SlipAndNoiseComeFromTheSeed) {
  SceneDescription scene = duelScene({0, -1500, 0}, {0, 1000});
  scene.noise.slip = 0.06;
  scene.noise.motion = 1;
  double sum = 0;
  std::vector<double> ways;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto world = worldOf(scene, seed);
    run(*world, standingCommand({0, 2, 0}), 500);
    ways.push_back(world->robot(0).pose.translation.x() + 1500);
    sum += ways.back();
    const auto again = worldOf(scene, seed);
    run(*again, standingCommand({0, 2, 0}), 500);
    EXPECT_EQ(again->robot(0).pose.translation, world->robot(0).pose.translation);
  }
  EXPECT_NEAR(sum / 40, 1000, 25);
  const auto [least, most] = std::minmax_element(ways.begin(), ways.end());
  EXPECT_LT(*least, 970);
  EXPECT_GT(*most, 1030);
  EXPECT_GT(*least, 850);
}

TEST(World, JointsFollowWithinTheirSpeed) {
  const auto world = worldOf(duelScene({}, {1000, 0}));
  RobotCommand command = standingCommand();
  command.joints[Joint::headPan] = 1.5;
  run(*world, command, 25);  // 200 ms
  const JointLimits limits = limitsOf(Joint::headPan);
  EXPECT_NEAR(world->robot(0).joints[Joint::headPan], 0.2 * motorOf(Joint::headPan).noLoadSpeed,
              1e-9);
  run(*world, command, 125);
  EXPECT_NEAR(world->robot(0).joints[Joint::headPan], 1.5, 1e-6);
  command.joints[Joint::headPan] = 10;
  run(*world, command, 100);
  EXPECT_NEAR(world->robot(0).joints[Joint::headPan], limits.high, 1e-6);
}

TEST(World, KicksPlayTheBallAsTheirTableSays) {
  KickTable table;
  ASSERT_TRUE(readConfig("config/kicks.cfg", table));
  for (const KickDescription& kick : table.kicks) {
    const KickedPlace row = *kick.at({kick.x, kick.y});
    double length = 0, turn = 0;
    int hits = 0;
    constexpr int kicks = 40;
    for (std::uint64_t seed = 0; seed < kicks; ++seed) {
      const auto world = worldOf(duelScene({pi / 2, 0, 0}, {1000, 0}), seed);
      run(*world, standingCommand(), 20);
      const Vector2d best{kick.x, kick.y};
      world->placeBall(0, Pose2D{pi / 2, 0, 0} * best);
      RobotCommand command = standingCommand();
      command.kick = &kick;
      const int ticks = static_cast<int>(std::lround(kick.strike / tickSeconds));
      run(*world, command, ticks);
      EXPECT_EQ(world->ball(0).speed.norm(), 0) << kick.motion << " strikes too early";
      run(*world, command, 2);
      const BallState& ball = world->ball(0);
      if (ball.lastToucher != 0) continue;
      ++hits;
      length += ball.speed.squaredNorm() / 500;
      turn += toDegrees(normalize(angleOf(ball.speed) - pi / 2 - fromDegrees(kick.direction)));
    }
    EXPECT_NEAR(hits, row.hits * kicks, 0.1 * kicks) << kick.motion;
    // Three times the standard deviation of the mean.
    const double many = 3 / std::sqrt(hits);
    EXPECT_NEAR(length / hits, kick.length, many * row.lengthDeviation) << kick.motion;
    EXPECT_NEAR(turn / hits, 0, many * row.spread) << kick.motion;
  }
}

TEST(World, BallsThatOthersKickMeetAKickingRobotAsOneThatStands) {
  KickTable table;
  ASSERT_TRUE(readConfig("config/kicks.cfg", table));
  int touched = 0;
  for (const KickDescription& kick : table.kicks) {
    const Pose2D pose{pi / 2, 0, 0};
    const Vector2d place = pose * Vector2d{kick.x, kick.y}, shoulder = pose * Vector2d{60, 60};
    const auto shootAt = [&](const KickDescription* performed) {
      auto world = worldOf(duelScene(pose, {1000, 0}));
      run(*world, standingCommand(), 20);
      RobotCommand command = standingCommand();
      command.kick = performed;
      world->placeBall(0, place);
      run(*world, command, 5);
      EXPECT_EQ(world->ball(0).position, place) << kick.motion;
      world->placeBall(0, place, 800 * (shoulder - place).normalized());
      run(*world, command, 15);
      return world;
    };
    const auto kicking = shootAt(&kick);
    const auto stands = shootAt(nullptr);
    EXPECT_EQ(kicking->ball(0).position, stands->ball(0).position) << kick.motion;
    touched += kicking->ball(0).lastToucher == 0;
  }
  EXPECT_GT(touched, 4);
}

TEST(World, BadCommandsChangeNothing) {
  const auto world = worldOf(duelScene({}, {1000, 0}));
  run(*world, standingCommand(), 200);
  const RobotBody before = world->robot(0);
  RobotCommand command;
  command.joints.values.fill(std::nan(""));
  command.step = {std::nan(""), INFINITY, 0};
  run(*world, command, 10);
  EXPECT_EQ(world->robot(0).joints.values, before.joints.values);
  EXPECT_EQ(world->robot(0).pose.translation, before.pose.translation);
  world->step({});
}

TEST(World, StandsOnAForeAndAHindFoot) {
  Random random{3};
  const auto world = worldOf(duelScene({0.7, 100, 200}, {1000, 0}));
  const RobotDimensions dimensions;
  for (int i = 0; i < 60; ++i) {
    RobotCommand command = standingCommand();
    for (int leg = 0; leg < 4; ++leg)
      for (int joint = 1; joint <= 3; ++joint)
        command.joints[legJoint(static_cast<Leg>(leg), joint)] += 0.35 * random.symmetric();
    run(*world, command, 100);
    std::array<double, 4> height;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const int site = world->parts(0).footSites[leg];
      height[leg] = 1000 * world->data().site_xpos[3 * site + 2] - dimensions.footRadius;
      EXPECT_EQ(world->robot(0).footOnGround[leg], height[leg] < 1);
    }
    EXPECT_NEAR(std::min(height[0], height[1]), 0, 1e-6);
    EXPECT_NEAR(std::min(height[2], height[3]), 0, 1e-6);
    EXPECT_EQ(world->robot(0).roll, 0);
    const Vector3d ahead = world->robot(0).origin().rotation.col(0);
    EXPECT_NEAR(std::asin(ahead.z()), world->robot(0).tilt, 1e-9);
  }
}

TEST(World, NeverSinksIntoTheGround) {
  Random random{4};
  const auto world = worldOf(duelScene({}, {1000, 0}));
  for (int i = 0; i < 200; ++i) {
    run(*world, {randomAngles(random), {}}, 60);
    ASSERT_GT(world->robot(0).height, 10);
    ASSERT_LT(world->robot(0).height, 190);
    for (const int site : world->parts(0).footSites)
      EXPECT_GT(1000 * world->data().site_xpos[3 * site + 2], 13.9);
  }
}

TEST(World, CameraHistoryIsThePast) {
  const auto world = worldOf(duelScene({}, {1000, 0}));
  RobotCommand command = standingCommand();
  run(*world, command, 100);
  command.joints[Joint::headPan] = 1;
  std::vector<Vector3d> poses;
  for (std::size_t i = 0; i < World::cameraHistory; ++i) {
    run(*world, command, 1);
    poses.insert(poses.begin(), world->camera(0).translation);
  }
  for (std::size_t ago = 0; ago < World::cameraHistory; ++ago)
    EXPECT_EQ(world->camera(0, ago).translation, poses[ago]);
  EXPECT_NE(poses[0], poses[1]);
  world->placeRobot(0, {0, 500, 0});
  run(*world, command, 1);
  EXPECT_EQ(world->camera(0, 3).translation, world->camera(0).translation);
}

/// How far two robots' footprints overlap, or one lies outside the field (mm).
double disorder(const World& world) {
  double worst = 0;
  for (std::size_t a = 0; a < world.robotCount(); ++a) {
    const Pose2D& p = world.robot(a).pose;
    worst = std::max(worst, std::abs(p.translation.y()) - 1350 + 75);
    worst = std::max(worst, std::abs(p.translation.x()) - 2400 + 75);
    for (std::size_t b = a + 1; b < world.robotCount(); ++b) {
      const Pose2D& q = world.robot(b).pose;
      for (const double x1 : RobotFootprint::middles)
        for (const double x2 : RobotFootprint::middles)
          worst = std::max(worst, 156 - (p * Vector2d{x1, 0} - q * Vector2d{x2, 0}).norm());
    }
  }
  return worst;
}

TEST(World, RobotsNeitherOverlapNorLeave) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SceneDescription scene = matchScene();
    scene.noise = {};
    const auto world = worldOf(scene, seed);
    Random random{seed};
    std::vector<RobotCommand> commands(8, standingCommand());
    for (int tick = 0; tick < 4000; ++tick) {
      if (tick % 100 == 0)
        for (RobotCommand& command : commands)
          command.step = {0.01 * random.symmetric(), 3 * random.symmetric(), random.symmetric()};
      world->step(commands);
      ASSERT_LT(disorder(*world), 8) << "seed " << seed << " tick " << tick;
    }
  }
}

TEST(World, AWallStopsARobotAndItsOdometryDoesNotKnow) {
  const auto world = worldOf(duelScene({0, 1500, 800}, {-1000, 0}));
  run(*world, standingCommand({0, 2, 0}), 1000);
  EXPECT_LT(world->robot(0).pose.translation.x(), 2100 - 130);
  EXPECT_GT(world->robot(0).pose.translation.x(), 1700);
}

TEST(World, ARobotPushesAnotherAlong) {
  SceneDescription scene = matchScene();
  scene.robots.resize(2);
  scene.robots[0].x = -800;
  scene.robots[0].y = 0;
  scene.robots[1].x = -500;
  scene.robots[1].y = 0;
  scene.balls.clear();
  const auto world = worldOf(scene);
  std::vector<RobotCommand> commands{standingCommand({0, 2, 0}), standingCommand()};
  for (int i = 0; i < 250; ++i) world->step(commands);
  EXPECT_GT(world->robot(1).pose.translation.x(), -350);
  EXPECT_LT(world->robot(0).pose.translation.x(), -500);
  EXPECT_LT(disorder(*world), 5);
}

TEST(World, ThrowOverLaysTheRobotOnItsSide) {
  const auto world = worldOf(duelScene({}, {1000, 0}));
  run(*world, standingCommand(), 50);
  world->throwOver(0, Posture::onRightSide);
  run(*world, standingCommand({0, 2, 0}), 50);
  const Pose3D origin = world->robot(0).origin();
  EXPECT_NEAR(origin.rotation.col(1).z(), 1, 1e-9);  // the left side looks up
  EXPECT_EQ(world->robot(0).pose.translation, Vector2d(0, 0));
  world->standUp(0);
  run(*world, standingCommand(), 1);
  EXPECT_NEAR(world->robot(0).origin().rotation.col(1).z(), 0, 1e-9);
}

}  // namespace
}  // namespace gt
