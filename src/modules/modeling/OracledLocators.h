#pragma once
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solves SelfLocator by asking the oracle (report 5.1), for work on what needs a pose before there
/// is one, and for comparison.
class OracledSelfLocator {
 public:
  void update(const OracledWorldState& oracle, RobotPose& pose);
};

/// Solves BallLocator by asking the oracle: the ball is seen all the time, wherever it is.
class OracledBallLocator {
 public:
  void update(const OracledWorldState& oracle, const FrameInfo& frame, BallModel& ball);

 private:
  Time first_ = never();
};

/// Solves PlayersLocator by asking the oracle.
class OracledPlayersLocator {
 public:
  void update(const OracledWorldState& oracle, const Player& player, const FrameInfo& frame,
              PlayersCollection& players);
};

/// Solves ObstaclesLocator by asking the oracle: all sectors are seen all the time. Obstacles are
/// the field's walls and the other robots, each as two discs.
class OracledObstaclesLocator {
 public:
  void update(const OracledWorldState& oracle, const FieldDimensions& field, const FrameInfo& frame,
              ObstaclesModel& obstacles);
};

}  // namespace gt
