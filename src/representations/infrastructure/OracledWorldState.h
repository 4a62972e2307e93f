#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// Where a robot truly is.
struct OracledRobot {
  TeamColor teamColor = TeamColor::red;
  int number = 0;
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{field<&OracledRobot::teamColor>(), field<&OracledRobot::number>("1 to 4"),
                  field<&OracledRobot::pose>(Unit::mmRad, "in this robot's field coordinates")};
  }
};

/// The truth, as only a simulator knows it (report 5.1). Provided by the platform. In the
/// coordinates of the robot's own team.
struct OracledWorldState {
  Time time;
  Pose2D robotPose;
  Vector2d ballPosition = Vector2d::Zero();
  Vector2d ballSpeed = Vector2d::Zero();
  std::vector<OracledRobot> others;

  static constexpr auto fields() {
    return Fields{field<&OracledWorldState::time>(Unit::ms),
                  field<&OracledWorldState::robotPose>(Unit::mmRad),
                  field<&OracledWorldState::ballPosition>(Unit::mm, "on the field"),
                  field<&OracledWorldState::ballSpeed>(Unit::mmPerS, "on the field"),
                  field<&OracledWorldState::others>("team mates and opponents")};
  }
};

}  // namespace gt
