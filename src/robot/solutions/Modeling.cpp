#include "modules/modeling/OracledLocators.h"
#include "modules/modeling/Tasks.h"
#include "modules/modeling/ball/BallChallengeBallLocator.h"
#include "modules/modeling/ball/PIDSmoothedBallLocator.h"
#include "modules/modeling/ball/ProbabilisticBallLocator.h"
#include "modules/modeling/obstacles/DefaultObstaclesLocator.h"
#include "modules/modeling/players/GO2003PlayersLocator.h"
#include "modules/modeling/players/TrackingPlayersLocator.h"
#include "modules/modeling/robotstate/DefaultRobotStateDetector.h"
#include "modules/modeling/selflocator/FusionSelfLocator.h"
#include "modules/modeling/selflocator/GT2003SelfLocator.h"
#include "modules/modeling/selflocator/KalmanSelfLocator.h"
#include "modules/modeling/selflocator/LinesSelfLocator.h"
#include "modules/modeling/selflocator/MonteCarloSelfLocator.h"
#include "modules/modeling/selflocator/SingleLandmarkSelfLocator.h"
#include "modules/modeling/team/DefaultTeamBallLocator.h"
#include "modules/modeling/team/DefaultTeamMessageSender.h"
#include "modules/modeling/team/FusedTeamBallLocator.h"
#include "robot/Solutions.h"

namespace gt {

void addModeling(RobotModules& modules) {
  SolutionTable& table = modules.solutions;
  table.add<SelfLocator, MonteCarloSelfLocator>("MonteCarlo");
  table.add<SelfLocator, FusionSelfLocator>("Fusion");
  table.add<SelfLocator, Fusion2003SelfLocator>("Fusion2003");
  table.add<SelfLocator, GT2003SelfLocator>("GT2003");
  table.add<SelfLocator, KalmanSelfLocator>("Kalman");
  table.add<SelfLocator, LinesSelfLocator>("Lines");
  table.add<SelfLocator, SingleLandmarkSelfLocator>("SingleLandmark");
  table.add<SelfLocator, OracledSelfLocator>("Oracled");
  table.add<BallLocator, PIDSmoothedBallLocator>("PIDSmoothed");
  table.add<BallLocator, BallChallengeBallLocator>("BallChallenge");
  table.add<BallLocator, ProbabilisticBallLocator>("Probabilistic");
  table.add<BallLocator, OracledBallLocator>("Oracled");
  table.add<TeamBallLocator, DefaultTeamBallLocator>("Default");
  table.add<TeamBallLocator, FusedTeamBallLocator>("Fused");
  table.add<PlayersLocator, GO2003PlayersLocator>("GO2003");
  table.add<PlayersLocator, TrackingPlayersLocator>("Tracks");
  table.add<PlayersLocator, OracledPlayersLocator>("Oracled");
  table.add<ObstaclesLocator, DefaultObstaclesLocator>("Default");
  table.add<ObstaclesLocator, OracledObstaclesLocator>("Oracled");
  table.add<RobotStateDetector, DefaultRobotStateDetector>("Default");
  table.add<TeamMessageSender, DefaultTeamMessageSender>("Default");
}

}  // namespace gt
