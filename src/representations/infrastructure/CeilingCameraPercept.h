#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// A robot that the ceiling camera recognized by the marks on its back.
struct MarkedRobot {
  TeamColor teamColor = TeamColor::red;
  int number = 0;
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{
        field<&MarkedRobot::teamColor>(),
        field<&MarkedRobot::number>("number of the player, 1 to 4"),
        field<&MarkedRobot::pose>(Unit::mmRad,
                                  "pose of the robot on the field, in the red team's coordinates")};
  }
};

/// Robots and ball seen by a camera at the ceiling in one image (report 6.2.2). Provided by the
/// simulated ceiling camera, or by the program of a real one, whose log has these messages on the
/// topic /CeilingCameraPercept.
struct CeilingCameraPercept {
  Time time;
  std::vector<MarkedRobot> robots;
  bool ballSeen = false;
  Vector2d ball = Vector2d::Zero();

  static constexpr auto fields() {
    using P = CeilingCameraPercept;
    return Fields{
        field<&P::time>(Unit::ms, "when the image was taken"), field<&P::robots>(),
        field<&P::ballSeen>("whether the ball was recognized"),
        field<&P::ball>(Unit::mm,
                        "position of the ball on the field, in the red team's coordinates")};
  }
};

}  // namespace gt
