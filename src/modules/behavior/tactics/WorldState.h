#pragma once
#include <tuple>

#include "modules/behavior/tactics/PlayValues.h"
#include "representations/behavior/PotentialFields.h"
#include "representations/behavior/TargetPoints.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"
#include "representations/perception/CollisionPercept.h"

namespace gt {

/// References to the inputs of the behavior in one cycle.
struct WorldState {
  const FrameInfo& frame;
  const Player& player;
  const FieldDimensions& field;
  const GameControlData& game;
  const RobotPose& self;
  const BallModel& ball;
  const TeamBallModel& teamBall;
  const ObstaclesModel& obstacles;
  const PlayersCollection& players;
  const RobotState& body;
  const TeamMessages& team;
  const MotionInfo& motion;
  const CollisionPercept& collision;
  const MotionNet& motions;
  const PotentialFields& fields;
  const TargetPoints& targets;
  const PlayValues& values;

  /// Each is an input of the module that takes a WorldState.
  using Parts =
      std::tuple<const FrameInfo&, const Player&, const FieldDimensions&, const GameControlData&,
                 const RobotPose&, const BallModel&, const TeamBallModel&, const ObstaclesModel&,
                 const PlayersCollection&, const RobotState&, const TeamMessages&,
                 const MotionInfo&, const CollisionPercept&, const MotionNet&,
                 const PotentialFields&, const TargetPoints&, const PlayValues&>;
};

}  // namespace gt
