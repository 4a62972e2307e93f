#pragma once
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/modeling/BallModel.h"
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

}  // namespace gt
