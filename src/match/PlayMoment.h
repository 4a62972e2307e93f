#pragma once
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "simulation/world/World.h"

namespace gt {

/// A tick of a match while the game runs, from the truth.
struct PlayMoment {
  struct Robot {
    TeamColor team = TeamColor::red;
    Vector2d position = Vector2d::Zero();  ///< mm, on the field
    Vector2d speed = Vector2d::Zero();     ///< mm/s, on the field, without what sways
    bool plays = true;                     ///< It is not penalized.
    bool kicks = false;                    ///< It performs a kick.
    std::string_view action;               ///< The special action that it performs; empty: none.
    bool hasRole = true;                   ///< Its role is known.
    DynamicRole role = DynamicRole::defensiveSupporter;
    double ballUnseen = 0;                   ///< ms, since its camera saw the ball
    Vector2d kickTarget = Vector2d::Zero();  ///< mm, on the field, if its role is known

    double distanceTo(const BallState& to) const { return (position - to.position).norm(); }
  };
  Time time;
  BallState ball;
  std::vector<Robot> robots;

  /// The goalie of a team; null if none plays.
  const Robot* goalie(TeamColor team) const {
    for (const Robot& robot : robots)
      if (robot.team == team && robot.plays && robot.role == DynamicRole::goalie) return &robot;
    return nullptr;
  }
  /// Whether a robot touched the ball since a time.
  bool touchedSince(std::size_t robot, Time since) const {
    return ball.lastToucher == static_cast<int>(robot) && ball.lastTouched >= since;
  }
};

/// Whether a ball that nobody stops rolls into the goal at which a team plays. `deceleration` in
/// mm/s^2.
bool rollsIntoGoal(const BallState& ball, TeamColor shooter, const FieldDimensions& field,
                   double deceleration);

/// A ball rolls if it is faster (mm/s).
constexpr double rollingBall = 50;
/// A robot is at the ball if its middle is nearer (mm).
constexpr double atBall = 350;
/// The ball is lost to a robot whose camera has not seen it for longer (ms).
constexpr double ballLost = 1000;

}  // namespace gt
