// A crowded scene in which everything goes wrong: nothing may break, and the memory stays what it
// was.
#include <fmt/core.h>
#include <unistd.h>

#include <fstream>

#include "Experiments.h"
#include "simulation/objects/TestChaos.h"

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

Result<Measurement> soak(const Job& job, const DataRoot& root) {
  auto scene = crowdedScene(22, 10, root.path("scenes/match.scene"));
  if (!scene) return scene.error();
  const std::string& fidelity = job.parameter("fidelity");
  const bool kinematic = fidelity == "kinematic";
  scene->fidelity = kinematic ? Fidelity::kinematic : Fidelity::dynamic;
  const double minutes = kinematic ? kinematicMinutes : dynamicMinutes;
  scene->game.minutes = 2 * minutes;
  auto simulation = Simulation::make(*scene, job.seed);
  if (!simulation) return simulation.error();
  Simulation& s = **simulation;
  Chaos chaos{s, job.seed};
  double memory = 0;
  int wrong = 0;
  const auto ticks = static_cast<int>(minutes * 60 / tickSeconds);
  for (int i = 0; i < ticks; ++i) {
    s.takeImages(i % 500 < 5);  // one each for four seconds
    chaos.step();
    if (i == ticks / 6) memory = memoryInUse();
    if (const std::string what = chaos.wrong(); !what.empty() && ++wrong == 1)
      fmt::print(stderr, "{}: {} s: {}\n", job.text(), s.time().ms / 1000, what);
  }
  Measurement measured;
  const std::string name = "soak." + fidelity;
  measured.add(name + ".simulated", "min", static_cast<double>(s.time().ms) / 60'000);
  measured.add(name + ".wrong", "ticks", wrong, Aim::atMost(0));
  measured.add(name + ".memoryGrowth", "MiB", memoryInUse() - memory, Aim::atMost(2));
  return measured;
}

}  // namespace

Experiment soakExperiment() {
  return {"soak",
          "A crowd while everything goes wrong: nothing breaks, the memory does not grow",
          {{"fidelity", "of the bodies", Parameter::Kind::each, {"kinematic", "dynamic"}}},
          soak,
          true,
          true};
}

}  // namespace gt
