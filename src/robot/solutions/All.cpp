#include "robot/Configuration.h"
#include "robot/Solutions.h"

namespace gt {

const SolutionTable& solutions() {
  static const SolutionTable table = [] {
    SolutionTable all = tasks();
    addPerceptionSolutions(all);
    addModelingSolutions(all);
    addBehaviorSolutions(all);
    addMotionSolutions(all);
    return all;
  }();
  return table;
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths) {
  return loadConfiguration(paths, solutions());
}

}  // namespace gt
