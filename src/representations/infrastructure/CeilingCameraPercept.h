#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// A robot as it was recognized from above by the marks on its back.
struct MarkedRobot {
  TeamColor teamColor = TeamColor::red;
  int number = 0;
  Pose2D pose;

  static constexpr auto fields() {
    return Fields{field<&MarkedRobot::teamColor>(), field<&MarkedRobot::number>("1 to 4"),
                  field<&MarkedRobot::pose>(Unit::mmRad, "in the red team's coordinates")};
  }
};

/// What a camera at the ceiling saw of the field in one image (report 6.2.2). Provided by the
/// simulated one, or by the program of a real one, whose log has these messages on the topic
/// /CeilingCameraPercept.
struct CeilingCameraPercept {
  Time time;
  std::vector<MarkedRobot> robots;
  bool ballSeen = false;
  Vector2d ball = Vector2d::Zero();

  static constexpr auto fields() {
    using P = CeilingCameraPercept;
    return Fields{field<&P::time>(Unit::ms, "when the image was taken"), field<&P::robots>(),
                  field<&P::ballSeen>("not hidden under a robot, nor overlooked"),
                  field<&P::ball>(Unit::mm, "in the red team's coordinates")};
  }
};

}  // namespace gt
