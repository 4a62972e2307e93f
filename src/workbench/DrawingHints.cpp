#include "workbench/DrawingHints.h"

#include <algorithm>

#include "framework/SolutionTable.h"

namespace gt {
namespace {

constexpr std::int64_t recent = 500;  // ms

}  // namespace

std::vector<DrawingHint> drawingHints(ObservedRobot& robot, const std::vector<std::string>& keys,
                                      const std::vector<std::string>& known) {
  std::vector<DrawingHint> hints;
  for (const std::string& key : keys) {
    if (!std::ranges::binary_search(known, key)) {
      hints.push_back({key, "unknown to " + robot.name()});
    } else if (robot.isHidden(key)) {
      hints.push_back({key, "off", true});
    } else if (robot.drawnAt(key) == never() || robot.time() - robot.drawnAt(key) > recent) {
      // Keys begin with the task that draws them.
      const std::string name = key.substr(0, key.find('/'));
      const auto task = robot.task(name);
      if (task && ((*task)->active.empty() || (*task)->active == SolutionTable::disabled))
        hints.push_back({key, name + " is disabled"});
    }
  }
  return hints;
}

}  // namespace gt
