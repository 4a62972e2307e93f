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

/// What all robots make of their teammates' balls, which reach them through a radio of this watch's
/// own, and perhaps of one robot that is lost.
class TeamBallWatch {
 public:
  /// `players` are all robots of the simulation in their order.
  TeamBallWatch(std::string name, const RadioParameters& radio, bool oneIsLost,
                const std::vector<Player>& players, const Random& random)
      : name_{std::move(name)},
        oneIsLost_{oneIsLost},
        radio_{radio, players, random},
        players_{players},
        robots_(players.size()) {}

  /// A robot sends a message to its teammates, where it arrives late or never.
  void send(std::size_t robot, TeamMessage message, Time now);
  /// The team ball of a robot that has received what has arrived by now, against its own ball.
  void update(std::size_t robot, const BallModel& ball, const RobotPose& pose,
              const OracledWorldState& truth, Tally& tally);

 private:
  struct Receiver {
    TeamMessages messages;
    DefaultTeamBallLocator chooses;
    FusedTeamBallLocator fuses;
  };

  std::string name_;
  bool oneIsLost_;
  Radio radio_;
  std::vector<Player> players_;
  std::vector<Receiver> robots_;
  Debug debug_{1024};
};

/// The obstacles of one robot, which it has modeled itself, against the truth.
void compareObstacles(const SimulatedRobot& robot, const OracledWorldState& truth, Tally& tally);
/// The players that a robot of a team knows, against the truth. One that it knows stands for one
/// robot of that team at most.
void comparePlayers(const PlayersCollection& players, TeamColor own, const OracledWorldState& truth,
                    Tally& tally);

}  // namespace gt
