#pragma once
#include "modules/behavior/tactics/WorldState.h"

namespace gt {

/// A state of the world defined by hand, for tests and experiments; not used on the robot.
struct ImaginedWorld {
  FrameInfo frame;
  Player player;
  FieldDimensions field;
  GameControlData game;
  RobotPose self;
  BallModel ball;
  TeamBallModel teamBall;
  ObstaclesModel obstacles;
  PlayersCollection players;
  RobotState body;
  TeamMessages team;
  MotionInfo motion;
  CollisionPercept collision;
  MotionNet motions;
  PotentialFields fields;
  TargetPoints targets;
  PlayValues values;

  WorldState state() const {
    return {frame, player, field,  game,      self,    ball,   teamBall, obstacles, players,
            body,  team,   motion, collision, motions, fields, targets,  values};
  }
};

}  // namespace gt
