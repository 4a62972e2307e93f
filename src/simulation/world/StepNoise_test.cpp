#include "simulation/world/StepNoise.h"

#include <gtest/gtest.h>

#include "base/Statistics.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

constexpr int ticksPerMeter = 500;

NoiseParameters noiseOf(double motion) {
  NoiseParameters noise;
  noise.motion = motion;
  return noise;
}

/// What noise adds to ways of a meter and to whole turns.
TEST(StepNoise, GrowsAsTheSceneSays) {
  RunningStatistics ahead, sideways, rotation, turned;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    StepNoise walks{Random{seed}}, turns{Random{seed}};
    Vector2d way = Vector2d::Zero();
    double rotated = 0, turn = 0;
    for (int i = 0; i < ticksPerMeter; ++i) {
      const Pose2D step = walks.next(noiseOf(2), {0, 1000. / ticksPerMeter, 0});
      way += step.translation;
      rotated += step.rotation;
      turn += turns.next(noiseOf(2), {2 * pi / ticksPerMeter, 0, 0}).rotation;
    }
    ahead.add(way.x());
    sideways.add(way.y());
    rotation.add(toDegrees(rotated));
    turned.add(toDegrees(turn));
  }
  EXPECT_NEAR(ahead.mean(), 0, 3);
  EXPECT_NEAR(ahead.standardDeviation(), 40, 4);
  EXPECT_NEAR(sideways.standardDeviation(), 40, 4);
  EXPECT_NEAR(rotation.standardDeviation(), 2, 0.2);
  EXPECT_NEAR(turned.standardDeviation(), 10, 1);
}

TEST(StepNoise, KeepsItsDirectionForAboutAStep) {
  StepNoise noise{Random{1}};
  RunningStatistics square, afterATick, afterASecond;
  std::vector<double> turns;
  for (int i = 0; i < 100'000; ++i)
    turns.push_back(noise.next(noiseOf(1), {0, 1000. / ticksPerMeter, 0}).rotation);
  for (std::size_t i = 0; i + 125 < turns.size(); ++i) {
    square.add(turns[i] * turns[i]);
    afterATick.add(turns[i] * turns[i + 1]);
    afterASecond.add(turns[i] * turns[i + 125]);
  }
  EXPECT_GT(afterATick.mean(), 0.95 * square.mean());
  EXPECT_LT(afterASecond.mean(), 0.15 * square.mean());
}

TEST(StepNoise, WhoDoesNotWalkIsNotMoved) {
  StepNoise noise{Random{1}};
  const Pose2D step = noise.next(noiseOf(5), {});
  EXPECT_EQ(step.rotation, 0);
  EXPECT_EQ(step.translation, Vector2d::Zero());
}

TEST(StepNoise, MovesRobotsThatBelieveToWalkInBothFidelities) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic})
    for (const double motion : {0., 5.}) {
      SceneDescription scene = duelScene({0, -1000, 0}, {1000, 1000});
      scene.fidelity = fidelity;
      scene.noise.motion = motion;
      const auto world = worldOf(scene, 3);
      run(*world, standingCommand(), 200);
      const Pose2D before = world->robot(0).pose;
      // In turns ahead and back: only noise leads elsewhere.
      for (int i = 0; i < 250; ++i) run(*world, standingCommand({0, i % 2 ? -2. : 2., 0}), 1);
      const Pose2D way = world->robot(0).pose.relativeTo(before);
      if (motion == 0)
        EXPECT_LT(way.translation.norm(), 3);
      else
        EXPECT_GT(way.translation.norm(), 10);
      EXPECT_EQ(world->robot(0).posture, Posture::standing);
    }
}

}  // namespace
}  // namespace gt
