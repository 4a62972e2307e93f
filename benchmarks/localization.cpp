// What a self-locator costs in each image: by the number of its particles and by what is seen.
#include <string>
#include <vector>

#include "Parts.h"
#include "modules/modeling/selflocator/FusionSelfLocator.h"
#include "modules/modeling/selflocator/KalmanSelfLocator.h"
#include "modules/modeling/selflocator/LinesSelfLocator.h"
#include "modules/modeling/testing/Locators.h"

namespace gt {
namespace {

struct Moment {
  OdometryData odometry;
  LandmarksPercept landmarks;
  LinesPercept lines;
  CameraMatrix camera;
};

/// What a robot saw while it walked about.
const std::vector<Moment>& walk() {
  static const std::vector<Moment> moments = [] {
    SyntheticRobot robot{1};
    std::vector<Moment> walked(2000);
    for (Moment& moment : walked) {
      robot.step();
      moment = {robot.odometry, robot.percept, robot.lines, robot.camera};
    }
    return walked;
  }();
  return moments;
}

/// The same walk, but each image shows exactly so many flags, well in sight.
std::vector<Moment> walkSeeing(int flags) {
  std::vector<Moment> moments = walk();
  for (Moment& moment : moments) {
    moment.landmarks.numberOfGoals = 0;
    moment.landmarks.numberOfFlags = flags;
    for (int i = 0; i < flags; ++i) {
      FlagPercept& flag = moment.landmarks.flags[static_cast<std::size_t>(i)];
      flag.type = static_cast<FlagType>(i);
      flag.angle = 0.4 * i - 0.4;
      flag.distance = 1500;
      flag.boundary = {flag.angle + 0.03, flag.angle - 0.03};
    }
  }
  return moments;
}

template <typename Solution>
void locate(benchmark::State& state, const std::vector<Moment>& moments,
            const typename Solution::Parameters& parameters) {
  const SyntheticRobot robot{1};
  LocatorOf<Solution> locator{parameters, 1};
  std::size_t next = 0;
  double sum = 0;
  const auto look = [&] {
    const Moment& m = moments[next++ % moments.size()];
    const Seen seen{m.landmarks, m.lines, m.camera, m.odometry, robot.field, robot.player};
    sum += locator(seen).validity;
  };
  look();  // the first one computes tables
  for ([[maybe_unused]] auto _ : state) look();
  benchmark::DoNotOptimize(sum);
}

template <typename Solution>
void add(const std::string& name, const typename Solution::Parameters& parameters,
         double atMost = 0, const std::vector<Moment>& moments = walk()) {
  benchmark::RegisterBenchmark(("speed.localization." + name).c_str(),
                               [=](benchmark::State& state) {
                                 if (atMost > 0) aim(state, atMost);
                                 locate<Solution>(state, moments, parameters);
                               })
      ->Apply(inMicroseconds);
}

bool addAll() {
  add<SingleLandmarkSelfLocator>("singlelandmark", {});
  add<KalmanSelfLocator>("kalman", {});
  for (const int particles : {30, 100, 1000}) {
    const std::string number = "." + std::to_string(particles);
    FusionSelfLocator::Parameters fusion;
    Fusion2003SelfLocator::Parameters fusion2003;
    fusion.localization.particles = fusion2003.localization.particles = particles;
    add<MonteCarloSelfLocator>("montecarlo" + number, {.particles = particles},
                               particles == 100 ? 4 : 0);
    add<FusionSelfLocator>("fusion" + number, fusion);
    add<LinesSelfLocator>("lines" + number, {.particles = particles});
    add<GT2003SelfLocator>("gt2003" + number, {.particles = particles});
    add<Fusion2003SelfLocator>("fusion2003" + number, fusion2003);
  }
  // As many as other particle filters are measured with, and how cost grows with percepts.
  for (const int particles : {30, 100, 1000})
    add<MonteCarloSelfLocator>("montecarlo.twoFlags." + std::to_string(particles),
                               {.particles = particles}, 0, walkSeeing(2));
  for (const int flags : {1, 4, 6})
    add<MonteCarloSelfLocator>("montecarlo.flags" + std::to_string(flags) + ".100",
                               {.particles = 100}, 0, walkSeeing(flags));
  for (const int points : {1, 5, 20}) {
    LinesSelfLocator::Parameters parameters;
    parameters.edges.points = points;
    add<LinesSelfLocator>("lines.points" + std::to_string(points) + ".100", parameters);
  }
  return true;
}

[[maybe_unused]] const bool added = addAll();

}  // namespace
}  // namespace gt
