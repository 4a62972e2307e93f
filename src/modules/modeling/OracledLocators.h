#pragma once
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solution *Oracled* of SelfLocator: takes the pose from the oracle (report 5.1), to develop
/// modules that need a pose before a self-locator works, and for comparison.
class OracledSelfLocator {
 public:
  /// Provides the true pose, with validity 1.
  void update(const OracledWorldState& oracle, RobotPose& pose);
};

/// Solution *Oracled* of BallLocator: the ball counts as seen all the time, wherever it is.
class OracledBallLocator {
 public:
  /// Provides the true ball relative to the robot (mm, mm/s), as seen in this frame and all frames
  /// before.
  void update(const OracledWorldState& oracle, const FrameInfo& frame, BallModel& ball);

 private:
  Time first_ = never();
};

/// Solution *Oracled* of PlayersLocator: takes the other robots from the oracle.
class OracledPlayersLocator {
 public:
  /// Provides the positions of all other robots of the scene on the field, as seen in this frame.
  void update(const OracledWorldState& oracle, const Player& player, const FrameInfo& frame,
              PlayersCollection& players);
};

/// Solution *Oracled* of ObstaclesLocator: all sectors count as seen all the time. Obstacles are
/// the field's walls and the other robots, each modeled as two discs.
class OracledObstaclesLocator {
 public:
  /// Provides the nearest obstacle in each sector relative to the robot, as seen in this frame.
  void update(const OracledWorldState& oracle, const FieldDimensions& field, const FrameInfo& frame,
              ObstaclesModel& obstacles);
};

}  // namespace gt
