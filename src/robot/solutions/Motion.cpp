#include "modules/motion/DefaultCollisionDetector.h"
#include "modules/motion/DefaultLedControl.h"
#include "modules/motion/DefaultMotionControl.h"
#include "modules/motion/GT2003HeadControl.h"
#include "modules/motion/InvKinWalkingEngine.h"
#include "modules/motion/MotionNetSpecialActions.h"
#include "modules/motion/Tasks.h"
#include "robot/Solutions.h"

namespace gt {

void addMotionSolutions(SolutionTable& table) {
  table.add<HeadControl, GT2003HeadControl>("GT2003");
  table.add<LEDControl, DefaultLedControl>("Default");
  table.add<WalkingEngine, InvKinWalkingEngine>("InvKin");
  table.add<SpecialActions, MotionNetSpecialActions>("GT2003MotionNet");
  table.add<MotionControl, DefaultMotionControl>("Default");
  table.add<CollisionDetector, DefaultCollisionDetector>("Default");
}

}  // namespace gt
