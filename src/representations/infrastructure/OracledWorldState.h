#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// True pose of a robot.
struct OracledRobot {
  TeamColor teamColor = TeamColor::red;
  int number = 0;
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{
        field<&OracledRobot::teamColor>(),
        field<&OracledRobot::number>("number of the player, 1 to 4"),
        field<&OracledRobot::pose>(
            Unit::mmRad, "pose on the field, in the coordinates of the receiving robot's team")};
  }
};

/// Ground truth, known to a simulator only (report 5.1). Provided by the platform. In the
/// coordinates of the robot's own team.
struct OracledWorldState {
  Time time;
  Pose2D robotPose;
  Vector2d ballPosition = Vector2d::Zero();
  Vector2d ballSpeed = Vector2d::Zero();
  std::vector<OracledRobot> others;

  static constexpr auto fields() {
    return Fields{
        field<&OracledWorldState::time>(Unit::ms),
        field<&OracledWorldState::robotPose>(Unit::mmRad),
        field<&OracledWorldState::ballPosition>(Unit::mm, "position of the ball on the field"),
        field<&OracledWorldState::ballSpeed>(Unit::mmPerS, "velocity of the ball on the field"),
        field<&OracledWorldState::others>("teammates and opponents")};
  }
};

}  // namespace gt
