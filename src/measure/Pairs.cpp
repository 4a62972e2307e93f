#include "measure/Pairs.h"

#include <algorithm>
#include <tuple>

namespace gt {

std::vector<std::optional<std::size_t>> pairNearest(const std::vector<Vector2d>& places,
                                                    const std::vector<Vector2d>& percepts,
                                                    double tolerance) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < percepts.size(); ++k)
      if (const double distance = (percepts[k] - places[i]).norm(); distance <= tolerance)
        pairs.emplace_back(distance, i, k);
  std::ranges::sort(pairs);
  std::vector<std::optional<std::size_t>> assigned(places.size());
  std::vector<bool> taken(percepts.size());
  for (const auto& [distance, place, percept] : pairs) {
    if (assigned[place] || taken[percept]) continue;
    assigned[place] = percept;
    taken[percept] = true;
  }
  return assigned;
}

}  // namespace gt
