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
    Vector2d speed = Vector2d::Zero();     ///< mm/s, on the field, without swaying
    bool plays = true;                     ///< It is not penalized.
    bool kicks = false;                    ///< It performs a kick.
    std::string_view action;               ///< The special action that it performs; empty: none.
    bool hasRole = true;                   ///< Its role is known.
    DynamicRole role = DynamicRole::defensiveSupporter;
    double ballUnseen = 0;                   ///< ms since its camera saw the ball
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

/// Whether a ball that no robot stops rolls into the goal that `shooter` attacks. `deceleration` is
/// that of the ball (mm/s^2).
bool rollsIntoGoal(const BallState& ball, TeamColor shooter, const FieldDimensions& field,
                   double deceleration);

/// A ball rolls if it is faster than this (mm/s).
constexpr double rollingBall = 50;
/// A robot is at the ball if its middle is nearer to it than this (mm).
constexpr double atBall = 350;
/// A robot has lost the ball if its camera has not seen it for longer than this (ms).
constexpr double ballLost = 1000;

}  // namespace gt
