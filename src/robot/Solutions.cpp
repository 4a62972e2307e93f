#include "robot/Solutions.h"

#include "modules/behavior/GT2003BehaviorControl.h"
#include "modules/modeling/DefaultRobotStateDetector.h"
#include "modules/modeling/DefaultTeamBallLocator.h"
#include "modules/modeling/DefaultTeamMessageSender.h"
#include "modules/modeling/MonteCarloSelfLocator.h"
#include "modules/modeling/PidSmoothedBallLocator.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/DefaultLedControl.h"
#include "modules/motion/DefaultMotionControl.h"
#include "modules/motion/GT2003HeadControl.h"
#include "modules/motion/InvKinWalkingEngine.h"
#include "modules/motion/MotionNetSpecialActions.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/DefaultSensorDataProcessor.h"
#include "modules/perception/GT2003ImageProcessor.h"
#include "modules/perception/Tasks.h"

namespace gt {

const SolutionTable& solutions() {
  static const SolutionTable table = [] {
    SolutionTable t;
    t.add<SensorDataProcessor, DefaultSensorDataProcessor>("Default");
    t.add<ImageProcessor, GT2003ImageProcessor>("GT2003");
    t.add<SelfLocator, MonteCarloSelfLocator>("MonteCarlo");
    t.add<BallLocator, PidSmoothedBallLocator>("PIDSmoothed");
    t.add<TeamBallLocator, DefaultTeamBallLocator>("Default");
    t.add<RobotStateDetector, DefaultRobotStateDetector>("Default");
    t.add<BehaviorControl, GT2003BehaviorControl>("GT2003");
    t.add<TeamMessageSender, DefaultTeamMessageSender>("Default");
    t.add<HeadControl, GT2003HeadControl>("GT2003");
    t.add<LEDControl, DefaultLedControl>("Default");
    t.add<WalkingEngine, InvKinWalkingEngine>("InvKin");
    t.add<SpecialActions, MotionNetSpecialActions>("GT2003MotionNet");
    t.add<MotionControl, DefaultMotionControl>("Default");
    return t;
  }();
  return table;
}

}  // namespace gt
