#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The ball as seen in one image (report 3.2.3). Provided by the ImageProcessor.
struct BallPercept {
  Time time;
  bool seen = false;
  Vector2d offset = Vector2d::Zero();
  Vector2d angle = Vector2d::Zero();
  double distanceByProjection = 0;
  double distanceBySize = 0;
  Vector2d centerInImage = Vector2d::Zero();
  double radiusInImage = 0;

  static constexpr auto fields() {
    return Fields{
        field<&BallPercept::time>(Unit::ms, "time of the image"),
        field<&BallPercept::seen>(),
        field<&BallPercept::offset>(Unit::mm,
                                    "position of the ball on the ground, relative to the robot"),
        field<&BallPercept::angle>(
            Unit::rad,
            "direction from the camera to the ball's center: horizontal (+ left) and vertical (+ "
            "up)"),
        field<&BallPercept::distanceByProjection>(
            Unit::mm,
            "distance from the camera to the ball's center, computed from the camera matrix; 0 if "
            "the ball is not below the horizon"),
        field<&BallPercept::distanceBySize>(
            Unit::mm,
            "distance from the camera to the ball's center, computed from the radius; 0 if too "
            "little is seen"),
        field<&BallPercept::centerInImage>(Unit::pixel),
        field<&BallPercept::radiusInImage>(Unit::pixel)};
  }
};

}  // namespace gt
