#pragma once
#include <vector>

#include "base/Random.h"
#include "match/Match.h"
#include "measure/Tally.h"
#include "modules/modeling/OracledLocators.h"
#include "modules/modeling/ball/BallChallengeBallLocator.h"
#include "modules/modeling/ball/PIDSmoothedBallLocator.h"
#include "modules/modeling/ball/ProbabilisticBallLocator.h"
#include "modules/modeling/obstacles/DefaultObstaclesLocator.h"
#include "modules/modeling/players/GO2003PlayersLocator.h"
#include "modules/modeling/team/DefaultTeamBallLocator.h"
#include "modules/modeling/team/FusedTeamBallLocator.h"

namespace gt {

/// What the true ball does, as far as it makes a difference to who looks at it.
enum class BallSituation { resting, rolling, kicked, hidden, lost };

/// The solutions of BallLocator, side by side on the percepts of one robot.
class BallWatch {
 public:
  void update(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally);
  const BallModel& pidSmoothed() const { return models_[0]; }
  const BallModel& probabilistic() const { return models_[2]; }

 private:
  PIDSmoothedBallLocator pidSmoothed_;
  BallChallengeBallLocator challenge_;
  ProbabilisticBallLocator probabilistic_;
  BallModel models_[3];
  double lastSpeed_ = 0;
  Time kicked_ = never(), perceived_ = never();
  Debug debug_{1024};
};

/// What the team makes of its robots' balls while some of their messages get lost, and perhaps one
/// robot is lost itself.
class TeamBallWatch {
 public:
  TeamBallWatch(std::string name, double loss, bool oneIsLost, std::uint64_t seed)
      : name_{std::move(name)}, loss_{loss}, oneIsLost_{oneIsLost}, random_{seed} {}

  /// One message of one robot to another, if it comes through.
  void send(const TeamMessage& message, Time now);
  /// The team ball of a robot, against its own.
  void update(const BallModel& ball, const RobotPose& pose, const OracledWorldState& truth,
              const Player& player, Tally& tally);

 private:
  std::string name_;
  double loss_;
  bool oneIsLost_;
  Random random_;
  TeamMessages messages_;
  DefaultTeamBallLocator default_;
  FusedTeamBallLocator fused_;
  Debug debug_{1024};
};

/// The obstacles and players of one robot, which it has modeled itself, against the truth.
void compareObstacles(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally);
void comparePlayers(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally);

}  // namespace gt
