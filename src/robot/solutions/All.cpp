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

}  // namespace gt
