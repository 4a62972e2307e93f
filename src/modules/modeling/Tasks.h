#pragma once
#include <tuple>

#include "representations/behavior/TeamMessage.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"

namespace gt {

/// Where the robot is on the field (report 3.3).
struct SelfLocator {
  using Outputs = std::tuple<RobotPose>;
};

/// Where the ball is that the robot itself has seen (report 3.4.1).
struct BallLocator {
  using Outputs = std::tuple<BallModel>;
};

/// Where the team knows the ball to be (report 3.4.2).
struct TeamBallLocator {
  using Outputs = std::tuple<TeamBallModel>;
};

/// Where other players are (report 3.7).
struct PlayersLocator {
  using Outputs = std::tuple<PlayersCollection>;
};

/// How far the ground around the robot is free (report 3.5).
struct ObstaclesLocator {
  using Outputs = std::tuple<ObstaclesModel>;
};

/// What has happened to the robot's body (report, chapter 3's table).
struct RobotStateDetector {
  using Outputs = std::tuple<RobotState>;
};

/// The robot's message to its teammates by radio (report 3.4.2).
struct TeamMessageSender {
  using Outputs = std::tuple<TeamMessage>;
};

using ModelingTasks = std::tuple<SelfLocator, BallLocator, TeamBallLocator, PlayersLocator,
                                 ObstaclesLocator, RobotStateDetector, TeamMessageSender>;

}  // namespace gt
