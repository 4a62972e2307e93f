#include "simulation/world/Gait.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/Statistics.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// How a body sways that walks so fast (mm/s), as the scene says, in a trot: diagonals are lifted
/// in turns, each foot so high (mm).
struct Swaying {
  RunningStatistics tilt, roll, height;  // deg, mm

  Swaying(const BodyParameters& body, double speed, double lift = 11, double bobbing = 0,
          double ahead = 0) {
    constexpr int warmUp = 1000, ticks = 50'000, cycle = 33;
    Gait gait{Random{1}};
    for (int i = 0; i < ticks; ++i) {
      const double phase = 2 * pi * i / cycle, stance = 140 + bobbing * std::sin(2 * phase);
      const double first = std::max(0., lift * std::sin(phase));
      const double second = std::max(0., -lift * std::sin(phase));
      const Sway& sway = gait.sway(body, {first, second, second, first}, stance, speed, ahead);
      if (i < warmUp) continue;
      tilt.add(toDegrees(sway.tilt));
      roll.add(toDegrees(sway.roll));
      height.add(stance + sway.height);
    }
  }
};

BodyParameters swayingBody() {
  BodyParameters body;
  body.swayTilt = 1;
  body.swayRoll = 2;
  body.swayHeight = 4;
  return body;
}

TEST(Gait, TheBodySwaysAsMuchAsTheSceneSays) {
  const Swaying walk{swayingBody(), 200};
  EXPECT_NEAR(walk.tilt.standardDeviation(), 1, 0.2);
  EXPECT_NEAR(walk.roll.standardDeviation(), 2, 0.4);
  EXPECT_NEAR(walk.height.standardDeviation(), 4, 0.8);
  EXPECT_NEAR(walk.roll.mean(), 0, 0.1);
  EXPECT_EQ((Swaying{swayingBody(), 0}.roll.standardDeviation()), 0);
}

// As in the dynamic fidelity (docs/realism.md).
TEST(Gait, TheBodyNodsFurtherTheHigherTheFeetAreLifted) {
  const Swaying low{swayingBody(), 200, 11}, high{swayingBody(), 200, 16.5};
  EXPECT_NEAR(high.tilt.standardDeviation() / low.tilt.standardDeviation(), 1.5, 0.1);
  EXPECT_NEAR(high.roll.standardDeviation() / low.roll.standardDeviation(), 1, 0.1);
}

TEST(Gait, WalkingBodiesSinkAndStandingOnesLess) {
  const Swaying walk{swayingBody(), 200}, stand{swayingBody(), 0};
  EXPECT_LT(walk.height.mean(), stand.height.mean() - 1);
  EXPECT_LT(stand.height.mean(), 140 - 1);
  EXPECT_EQ(stand.tilt.mean(), 0);
}

TEST(Gait, WalkingBodiesLeanToTheirNosesMostIfTheyWalkAhead) {
  const auto lean = [](double speed, double ahead) {
    return Swaying{swayingBody(), speed, 11, 0, ahead}.tilt.mean();
  };
  EXPECT_NEAR(lean(200, 1), -1.65, 0.05);
  EXPECT_NEAR(lean(200, 0), -0.6, 0.05);
  EXPECT_NEAR(lean(200, -1), 0.45, 0.05);
}

// As in the dynamic fidelity (docs/realism.md).
TEST(Gait, LongStrokesSwayWithoutRule) {
  const Swaying slow{swayingBody(), 100}, usual{swayingBody(), 200}, fast{swayingBody(), 350};
  EXPECT_NEAR(usual.tilt.standardDeviation() / slow.tilt.standardDeviation(), 1, 0.1);
  EXPECT_GT(fast.tilt.standardDeviation(), 1.3 * usual.tilt.standardDeviation());
  EXPECT_GT(fast.height.standardDeviation(), 1.3 * usual.height.standardDeviation());
}

TEST(Gait, LegsThatGiveCarryTheBodyMoreEvenly) {
  BodyParameters body;
  body.swayHeight = 1e-6;
  EXPECT_LT((Swaying{body, 200, 11, 3}.height.standardDeviation()), 1);
  body.swayHeight = 0;
  body.swayTilt = 1;
  EXPECT_GT((Swaying{body, 200, 11, 3}.height.standardDeviation()), 2);
}

TEST(Gait, SwaysTheBodyOfAWalkingRobotAndItsAccelerationFeelsIt) {
  SceneDescription scene = duelScene({}, {1500, 1000});
  scene.body.swayRoll = 2;
  const auto world = worldOf(scene);
  RunningStatistics standing, walking, felt;
  for (int i = 0; i < 1000; ++i) {
    const bool walks = i >= 500;
    RobotCommand command = standingCommand(walks ? Pose2D{0.02, 1.6, 0} : Pose2D{});
    if (walks)
      for (const Joint knee : i / 16 % 2 == 0 ? std::array{Joint::legFR3, Joint::legHL3}
                                              : std::array{Joint::legFL3, Joint::legHR3})
        command.joints[knee] += 0.4;
    world->step({&command, 1});
    (walks ? walking : standing).add(toDegrees(world->robot(0).roll));
    felt.add(world->robot(0).specificForce.y() / 9810 -
             std::sin(world->robot(0).roll) * std::cos(world->robot(0).tilt));
  }
  EXPECT_EQ(standing.standardDeviation(), 0);
  EXPECT_GT(walking.standardDeviation(), 1);
  EXPECT_LT(walking.standardDeviation(), 3);
  EXPECT_NEAR(felt.high(), 0, 0.01);
  EXPECT_NEAR(felt.low(), 0, 0.01);
}

/// How far a robot gets in some seconds that believes to go 150 mm/s ahead.
double walked(const WalkingParameters& walking, double seconds, double speed = 150) {
  SceneDescription scene = duelScene({0, -1900, 0}, {1500, 1000});
  scene.walking = walking;
  const auto world = worldOf(scene);
  const RobotCommand command = standingCommand({0, speed * tickSeconds, 0});
  for (int i = 0; i < seconds / tickSeconds; ++i) world->step({&command, 1});
  return world->robot(0).pose.translation.x() + 1900;
}

TEST(Gait, WaysAreShorterOnACarpetAndAtHigherSpeed) {
  EXPECT_NEAR(walked({}, 10), 1500, 1e-6);
  WalkingParameters carpet;
  carpet.shortfall = 0.1;
  EXPECT_NEAR(walked(carpet, 10), 1350, 1e-6);
  carpet.gaitShortfall = 0.2;
  EXPECT_NEAR(walked(carpet, 10, 150), (1 - 0.1 - 0.15) * 1500, 1e-6);
  EXPECT_NEAR(walked(carpet, 10, 75), (1 - 0.1 - 0.075) * 750, 1e-6);
}

TEST(Gait, SlipsInBursts) {
  WalkingParameters walking;
  walking.bursts = 30;
  walking.burstTime = 0.4;
  walking.burstSlip = 0.7;
  Gait gait{Random{3}};
  int bursts = 0, slipping = 0;
  bool before = false;
  constexpr int minutes = 200, ticks = minutes * 60 * 125;
  for (int i = 0; i < ticks; ++i) {
    const double share = gait.progress(walking, 150);
    const bool slips = share < 1;
    EXPECT_TRUE(!slips || std::abs(share - 0.3) < 1e-12);
    bursts += slips && !before;
    slipping += slips;
    before = slips;
  }
  // While it slips it cannot begin to.
  EXPECT_NEAR(bursts / static_cast<double>(minutes), 30 / (1 + 30 * 0.4 / 60), 1.5);
  EXPECT_NEAR(slipping * tickSeconds / bursts, 0.4, 0.04);
}

TEST(Gait, AWallTurnsWhoWalksAgainstIt) {
  for (const double most : {0.0, 30.0}) {
    RunningStatistics turned;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SceneDescription scene = duelScene({0, 1900, 700}, {-1500, -1000});
      scene.walking.contactTurn = most;
      const auto world = worldOf(scene, seed);
      const RobotCommand command = standingCommand({0, 1.2, 0});
      for (int i = 0; i < 250; ++i) world->step({&command, 1});
      turned.add(toDegrees(world->robot(0).pose.rotation));
    }
    EXPECT_LE(std::max(turned.high(), -turned.low()), 2 * most);
    EXPECT_GE(turned.standardDeviation(), 0.3 * most);
  }
}

TEST(Gait, LegsThatSomethingHoldsUpLagAndTheBodyShakes) {
  const auto walked = [](double wallAt, double lag, double shaking) {
    SceneDescription scene = duelScene({0, wallAt, 700}, {-1500, -1000});
    scene.walking.contactLag = lag;
    scene.walking.contactShaking = shaking;
    const auto world = worldOf(scene, 1);
    RobotCommand command = standingCommand({0, 1.2, 0});
    const double stand = command.joints[Joint::legFR1];
    RunningStatistics off, felt;
    for (int i = 0; i < 500; ++i) {
      command.joints[Joint::legFR1] = stand + 0.3 * std::sin(0.2 * i);
      world->step({&command, 1});
      if (i < 250) continue;
      off.add(world->robot(0).joints[Joint::legFR1] - command.joints[Joint::legFR1]);
      felt.add(world->robot(0).specificForce.x());
    }
    return std::pair{off.standardDeviation(), felt.standardDeviation()};
  };
  constexpr double free = 0, wall = 1900;
  const auto [lag, shaking] = walked(free, 0.5, 3000);
  const auto [plainLag, plainShaking] = walked(wall, 0, 0);
  const auto [heldLag, heldShaking] = walked(wall, 0.5, 3000);
  EXPECT_NEAR(lag, plainLag, 1e-9);
  EXPECT_GT(heldLag, 1.5 * lag);
  EXPECT_LT(shaking, 100);
  EXPECT_LT(plainShaking, 100);
  EXPECT_NEAR(heldShaking, 3000, 300);
}

}  // namespace
}  // namespace gt
