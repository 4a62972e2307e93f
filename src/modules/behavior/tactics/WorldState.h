#pragma once
#include <algorithm>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"

namespace gt {

/// A special action as XABSL's enumeration special_action has it: its index in MotionNet::motions.
enum class SpecialAction : int {};

/// What the behavior decides on, in one cycle: the models, and a few things derived from them.
/// Filled by BehaviorControl.
struct WorldState {
  Time now;
  Player player;
  FieldDimensions field;
  GameControlData game;
  RobotPose self;
  BallModel ball;
  TeamBallModel teamBall;
  RobotState body;
  TeamMessages team;
  MotionInfo motion;
  const MotionNet* motions = nullptr;
  ObstaclesModel obstacles;
  PlayersCollection players;

  /// Enters the team mates that told where they are among the obstacles, for the camera does not
  /// see what is behind the robot.
  void addMatesToObstacles();

  /// The known ball relative to the robot: its own if it saw it lately, else the team's
  /// (report 3.8.2).
  Vector2d knownBall() const {
    return ownBall() ? ball.position : relative(self.pose, teamBall.position);
  }
  Vector2d knownBallOnField() const {
    return ownBall() ? self.pose * ball.position : teamBall.position;
  }
  std::int64_t knownBallAge() const {
    return std::min(now - ball.lastSeen, now - teamBall.lastSeen);
  }
  bool ownBall() const { return ball.lastSeen >= teamBall.lastSeen || now - ball.lastSeen < 2000; }

  Vector2d opponentGoal() const { return {field.xGroundline, 0}; }
  Vector2d ownGoal() const { return {-field.xGroundline, 0}; }

  /// A special action by its index; that of extern, which is none, for a wrong one.
  const MotionNet::Motion& specialAction(SpecialAction action) const {
    static const MotionNet::Motion none;
    const auto index = static_cast<std::size_t>(action);
    return motions && index < motions->motions.size() ? motions->motions[index] : none;
  }

  /// Messages of team mates that are not older than two seconds.
  template <typename Visit>
  void forEachMate(Visit&& visit) const {
    for (const TeamMessages::Received& received : team.byPlayer)
      if (received.message.playerNumber != 0 && received.message.playerNumber != player.number() &&
          now - received.timeReceived < 2000)
        visit(received.message);
  }
};

/// How long the robot needs to the ball, in ms: by distance, by the angle to turn, by how long the
/// ball is out of sight and by being on the wrong side of it (report 3.8.2).
double estimatedTimeToReachBall(const WorldState& world);

/// The role that a field player takes by comparing its time to the ball with what its team mates
/// told; the present striker has a little advantage so that roles do not flicker. The goalie stays
/// goalie.
DynamicRole negotiateRole(const WorldState& world, DynamicRole before);

/// The direction in which to play the ball, on the field: to the opponent goal, out of the own one
/// for a ball beside it.
double kickDirection(const WorldState& world);

/// How far a kick may go astray to either side: as long as it still hits the goal, and more
/// generously from far away.
double kickTolerance(const WorldState& world);

}  // namespace gt
