#include "simulation/PutText.h"

#include <fmt/format.h>

namespace gt {

std::vector<std::string> describe(const Simulation& simulation, const Put& put) {
  const std::string name = !put.ball        ? simulation.scene().allRobots()[put.index]->name
                           : put.index == 0 ? "ball"
                                            : fmt::format("ball{}", put.index);
  std::vector<std::string> lines;
  if (put.place != put.asked)
    lines.push_back(fmt::format("{}: {:.0f} {:.0f} is taken; put at {:.0f} {:.0f}, {:.1f} mm away",
                                name, put.asked.x(), put.asked.y(), put.place.x(), put.place.y(),
                                (put.place - put.asked).norm()));
  const double fastest = simulation.scene().physics.maxSpeed;
  if (put.askedSpeed > fastest)
    lines.push_back(fmt::format("{}: {:.0f} mm/s is too fast; it rolls with {:.0f} mm/s", name,
                                put.askedSpeed, fastest));
  return lines;
}

std::vector<std::string> describePuts(const Simulation& simulation) {
  std::vector<std::string> lines;
  for (const Put& put : simulation.world().puts())
    for (std::string& line : describe(simulation, put)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace gt
