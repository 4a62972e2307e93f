#include "modules/behavior/control/GT2003BehaviorControl.h"
#include "robot/Solutions.h"

namespace gt {

void addBehaviorSolutions(SolutionTable& table) {
  table.add<BehaviorControl, GT2003BehaviorControl>("GT2003");
}

}  // namespace gt
