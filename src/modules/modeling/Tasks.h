#pragma once
#include <tuple>

#include "representations/behavior/TeamMessage.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"

namespace gt {

/// The task of estimating the robot's pose on the field (report 3.3).
struct SelfLocator {
  using Outputs = std::tuple<RobotPose>;
};

/// The task of estimating position and speed of the ball from the robot's own percepts (report
/// 3.4.1).
struct BallLocator {
  using Outputs = std::tuple<BallModel>;
};

/// The task of estimating the ball on the field from the observations of all robots of the team
/// (report 3.4.2).
struct TeamBallLocator {
  using Outputs = std::tuple<TeamBallModel>;
};

/// The task of estimating the positions of other players (report 3.7).
struct PlayersLocator {
  using Outputs = std::tuple<PlayersCollection>;
};

/// The task of estimating how far the ground around the robot is free (report 3.5).
struct ObstaclesLocator {
  using Outputs = std::tuple<ObstaclesModel>;
};

/// The task of detecting falls, lifting and pressed switches (report, chapter 3's table).
struct RobotStateDetector {
  using Outputs = std::tuple<RobotState>;
};

/// The task of composing the robot's radio message to its teammates (report 3.4.2).
struct TeamMessageSender {
  using Outputs = std::tuple<TeamMessage>;
};

using ModelingTasks = std::tuple<SelfLocator, BallLocator, TeamBallLocator, PlayersLocator,
                                 ObstaclesLocator, RobotStateDetector, TeamMessageSender>;

}  // namespace gt
