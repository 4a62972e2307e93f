#pragma once
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solution *Oracled* of SelfLocator: asks the oracle (report 5.1), for work on what needs a pose
/// before there is one, and for comparison.
class OracledSelfLocator {
 public:
  /// Provides the true pose, with validity 1.
  void update(const OracledWorldState& oracle, RobotPose& pose);
};

/// Solution *Oracled* of BallLocator: the ball is seen all the time, wherever it is.
class OracledBallLocator {
 public:
  /// Provides the true ball relative to the robot, seen in this frame and in all before.
  void update(const OracledWorldState& oracle, const FrameInfo& frame, BallModel& ball);

 private:
  Time first_ = never();
};

/// Solution *Oracled* of PlayersLocator.
class OracledPlayersLocator {
 public:
  /// Provides all other robots of the scene on the field, seen in this frame.
  void update(const OracledWorldState& oracle, const Player& player, const FrameInfo& frame,
              PlayersCollection& players);
};

/// Solution *Oracled* of ObstaclesLocator: all sectors are seen all the time. Obstacles are the
/// field's walls and the other robots, each as two discs.
class OracledObstaclesLocator {
 public:
  /// Provides how far it is to the next obstacle in each sector, seen in this frame.
  void update(const OracledWorldState& oracle, const FieldDimensions& field, const FrameInfo& frame,
              ObstaclesModel& obstacles);
};

}  // namespace gt
