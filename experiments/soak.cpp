// A crowded scene in which everything goes wrong: nothing may break, and the memory stays what it
// was.
#include <unistd.h>

#include <fstream>

#include "Experiments.h"
#include "simulation/TestChaos.h"

namespace gt {
namespace {

/// Contacts of 22 robots that lie upon each other cost some fifty times as much as kinematics.
constexpr double kinematicMinutes = 30, dynamicMinutes = 3;

/// The memory that this program has in use (MiB), without what the system may drop at any time.
double memoryInUse() {
  std::ifstream file{"/proc/self/statm"};
  double total = 0, resident = 0, ofFiles = 0;
  file >> total >> resident >> ofFiles;
  return (resident - ofFiles) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

Result<void> soak(Figures& figures, Fidelity fidelity, std::uint64_t seed) {
  auto scene = crowdedScene(22, 10);
  if (!scene) return scene.error();
  scene->fidelity = fidelity;
  const double minutes = fidelity == Fidelity::kinematic ? kinematicMinutes : dynamicMinutes;
  scene->game.minutes = 2 * minutes;
  auto simulation = Simulation::make(*scene, seed);
  if (!simulation) return simulation.error();
  Simulation& s = **simulation;
  Chaos chaos{s, seed};
  double memory = 0;
  int wrong = 0;
  const auto ticks = static_cast<int>(minutes * 60 / tickSeconds);
  for (int i = 0; i < ticks; ++i) {
    s.takePictures(i % 500 < 5);  // one each for four seconds
    chaos.step();
    if (i == ticks / 6) memory = memoryInUse();
    if (const std::string what = chaos.wrong(); !what.empty()) {
      if (++wrong == 1) fmt::print("soak, {} s: {}\n", s.time().ms / 1000, what);
    }
  }
  const std::string name = "soak." + std::string{enumName(fidelity)};
  figures.add(name + ".simulated", "min", {static_cast<double>(s.time().ms) / 60'000});
  figures.add(name + ".wrong", "ticks", {static_cast<double>(wrong)}, Aim::atMost(0));
  figures.add(name + ".memoryGrowth", "MiB", {memoryInUse() - memory}, Aim::atMost(2));
  return {};
}

}  // namespace

Result<void> measureSoak(Figures& figures, const ExperimentOptions& options) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic})
    if (auto done = soak(figures, fidelity, options.seeds.front()); !done) return done;
  return {};
}

}  // namespace gt
