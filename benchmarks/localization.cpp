// What a self-locator costs in each picture, by the number of its samples.
#include <string>
#include <type_traits>
#include <vector>

#include "Parts.h"
#include "base/Random.h"
#include "modules/modeling/FusionSelfLocator.h"
#include "modules/modeling/testing/SyntheticRobot.h"

namespace gt {
namespace {

struct Moment {
  OdometryData odometry;
  LandmarksPercept percept;
};

/// What a robot saw while it walked about.
const std::vector<Moment>& walk() {
  static const std::vector<Moment> moments = [] {
    SyntheticRobot robot{1};
    std::vector<Moment> walked(2000);
    for (Moment& moment : walked) {
      robot.step();
      moment = {robot.odometry, robot.percept};
    }
    return walked;
  }();
  return moments;
}

template <typename Solution>
void locate(benchmark::State& state, const typename Solution::Parameters& parameters) {
  const std::vector<Moment>& moments = walk();
  const SyntheticRobot robot{1};
  Solution locator;
  locator.parameters = parameters;
  RobotPose pose;
  Random random{1};
  Debug debug{1024};
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Moment& m = moments[next++ % moments.size()];
    if constexpr (std::is_same_v<Solution, SingleLandmarkSelfLocator>)
      locator.update(m.percept, m.odometry, robot.field, robot.player, pose, debug);
    else
      locator.update(m.percept, m.odometry, robot.field, robot.player, pose, random, debug);
  }
  benchmark::DoNotOptimize(pose);
}

void singleLandmark(benchmark::State& state) {
  locate<SingleLandmarkSelfLocator>(state, {});
}
void fusion(benchmark::State& state) {
  locate<FusionSelfLocator>(state, {});
}
void monteCarlo(benchmark::State& state, int samples) {
  locate<MonteCarloSelfLocator>(state, {.samples = samples});
}

BENCHMARK(singleLandmark)->Name("speed.localization.singlelandmark")->Apply(inMicroseconds);
BENCHMARK(fusion)->Name("speed.localization.fusion.30")->Apply(inMicroseconds);
BENCHMARK_CAPTURE(monteCarlo, few, 30)
    ->Name("speed.localization.montecarlo.30")
    ->Apply(inMicroseconds);
BENCHMARK_CAPTURE(monteCarlo, some, 100)
    ->Name("speed.localization.montecarlo.100")
    ->Apply(inMicroseconds);
BENCHMARK_CAPTURE(monteCarlo, many, 1000)
    ->Name("speed.localization.montecarlo.1000")
    ->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
