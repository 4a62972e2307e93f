#include "modules/modeling/BallChallengeBallLocator.h"
#include "modules/modeling/DefaultObstaclesLocator.h"
#include "modules/modeling/DefaultRobotStateDetector.h"
#include "modules/modeling/DefaultTeamBallLocator.h"
#include "modules/modeling/DefaultTeamMessageSender.h"
#include "modules/modeling/FusedTeamBallLocator.h"
#include "modules/modeling/Fusion2003SelfLocator.h"
#include "modules/modeling/FusionSelfLocator.h"
#include "modules/modeling/GO2003PlayersLocator.h"
#include "modules/modeling/GT2003SelfLocator.h"
#include "modules/modeling/KalmanSelfLocator.h"
#include "modules/modeling/LinesSelfLocator.h"
#include "modules/modeling/MonteCarloSelfLocator.h"
#include "modules/modeling/OracledLocators.h"
#include "modules/modeling/PidSmoothedBallLocator.h"
#include "modules/modeling/ProbabilisticBallLocator.h"
#include "modules/modeling/SingleLandmarkSelfLocator.h"
#include "modules/modeling/Tasks.h"
#include "robot/Solutions.h"

namespace gt {

void addModelingSolutions(SolutionTable& table) {
  table.add<SelfLocator, MonteCarloSelfLocator>("MonteCarlo");
  table.add<SelfLocator, FusionSelfLocator>("Fusion");
  table.add<SelfLocator, Fusion2003SelfLocator>("Fusion2003");
  table.add<SelfLocator, GT2003SelfLocator>("GT2003");
  table.add<SelfLocator, KalmanSelfLocator>("Kalman");
  table.add<SelfLocator, LinesSelfLocator>("Lines");
  table.add<SelfLocator, SingleLandmarkSelfLocator>("SingleLandmark");
  table.add<SelfLocator, OracledSelfLocator>("Oracled");
  table.add<BallLocator, PidSmoothedBallLocator>("PIDSmoothed");
  table.add<BallLocator, BallChallengeBallLocator>("BallChallenge");
  table.add<BallLocator, ProbabilisticBallLocator>("Probabilistic");
  table.add<BallLocator, OracledBallLocator>("Oracled");
  table.add<TeamBallLocator, DefaultTeamBallLocator>("Default");
  table.add<TeamBallLocator, FusedTeamBallLocator>("Fused");
  table.add<PlayersLocator, GO2003PlayersLocator>("GO2003");
  table.add<PlayersLocator, OracledPlayersLocator>("Oracled");
  table.add<ObstaclesLocator, DefaultObstaclesLocator>("Default");
  table.add<ObstaclesLocator, OracledObstaclesLocator>("Oracled");
  table.add<RobotStateDetector, DefaultRobotStateDetector>("Default");
  table.add<TeamMessageSender, DefaultTeamMessageSender>("Default");
}

}  // namespace gt
