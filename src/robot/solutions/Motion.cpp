#include "modules/motion/Tasks.h"
#include "modules/motion/collisions/MotorModelCollisionDetector.h"
#include "modules/motion/collisions/ReportCollisionDetector.h"
#include "modules/motion/control/DebugMotionControl.h"
#include "modules/motion/control/DefaultLEDControl.h"
#include "modules/motion/control/DefaultMotionControl.h"
#include "modules/motion/control/DefaultSoundControl.h"
#include "modules/motion/getup/GravityGetupEngine.h"
#include "modules/motion/head/ActiveVisionHeadControl.h"
#include "modules/motion/head/GT2003HeadControl.h"
#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "robot/Solutions.h"

namespace gt {

void addMotion(RobotModules& modules) {
  addMotionNet(modules);
  SolutionTable& table = modules.solutions;
  table.add<HeadControl, GT2003HeadControl>("GT2003");
  table.add<HeadControl, ActiveVisionHeadControl>("ActiveVision");
  table.add<LEDControl, DefaultLEDControl>("Default");
  table.add<SoundControl, DefaultSoundControl>("Default");
  table.add<WalkingEngine, InvKinWalkingEngine>("InvKin");
  table.add<SpecialActions, GT2003MotionNetSpecialActions>("GT2003MotionNet");
  table.add<GetupEngine, GravityGetupEngine>("Gravity");
  table.add<MotionControl, DefaultMotionControl>("Default");
  table.add<MotionControl, DebugMotionControl>("Debug");
  table.add<CollisionDetector, MotorModelCollisionDetector>("MotorModel");
  table.add<CollisionDetector, ReportCollisionDetector>("Report");
}

}  // namespace gt
