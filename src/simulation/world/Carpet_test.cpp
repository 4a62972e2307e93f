#include "simulation/world/Carpet.h"

#include <gtest/gtest.h>

#include "base/Statistics.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

TEST(Carpet, PullsEverywhereOtherwiseAndOnAverageNot) {
  const Carpet carpet{7, 150};
  RunningStatistics x, y;
  double roughest = 0;
  for (double at = -2000; at < 2000; at += 10) {
    const Vector2d pull = carpet.pull({at, 0.37 * at});
    x.add(pull.x());
    y.add(pull.y());
    roughest = std::max(roughest, (carpet.pull({at + 1, 0.37 * at}) - pull).norm());
  }
  for (const RunningStatistics& one : {x, y}) {
    EXPECT_NEAR(one.mean(), 0, 0.15);
    EXPECT_GT(one.standardDeviation(), 0.25);
    EXPECT_LE(one.high(), 1);
    EXPECT_GE(one.low(), -1);
  }
  EXPECT_LT(roughest, 3.0 / 150);
  EXPECT_NE(Carpet(8, 150).pull({100, 100}), carpet.pull({100, 100}));
}

/// Where balls end that roll from one place at one speed.
std::vector<Vector2d> rolled(Fidelity fidelity, double dents, std::uint64_t seed) {
  SceneDescription scene = duelScene({0, -1800, 900}, {0, 0});
  scene.fidelity = fidelity;
  scene.physics.dents = dents;
  const auto world = worldOf(scene, seed);
  std::vector<Vector2d> ends;
  const std::vector<RobotCommand> commands(1, standingCommand());
  for (const double y : {-300.0, 0.0, 300.0}) {
    world->placeBall(0, {-500, y}, {600, 0});
    for (int i = 0; i < 500; ++i) world->step(commands);
    EXPECT_LT(world->ball(0).speed.norm(), 3) << "it comes to rest";
    ends.push_back(world->ball(0).position - Vector2d{-500, y});
  }
  return ends;
}

TEST(Carpet, DeflectsBallsInBothFidelities) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
    const auto even = rolled(fidelity, 0, 1), dented = rolled(fidelity, 60, 1),
               again = rolled(fidelity, 60, 1), other = rolled(fidelity, 60, 2);
    for (std::size_t i = 0; i < even.size(); ++i) {
      EXPECT_NEAR(even[i].y(), 0, 2);
      // 60 mm/s^2 for the 2.4 s that it rolls are 170 mm at most.
      EXPECT_GT((dented[i] - even[i]).norm(), 1);
      EXPECT_LT((dented[i] - even[i]).norm(), 170);
      EXPECT_EQ(dented[i], again[i]);
      EXPECT_NE(dented[i], other[i]) << "each seed has its own carpet";
    }
  }
}

}  // namespace
}  // namespace gt
