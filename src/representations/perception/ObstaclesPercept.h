#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// A piece of free ground along one scan line (report 3.2). The ground is free between the two
/// points. An obstacle is behind the far point unless that lies on the image border. The ground
/// before the near point is unknown. Both points are the same if the ground next to the robot is
/// not free.
struct FreeGround {
  Vector2d nearPoint = Vector2d::Zero();
  Vector2d farPoint = Vector2d::Zero();
  bool farOnBorder = false;

  static constexpr auto fields() {
    return Fields{
        field<&FreeGround::nearPoint>(Unit::mm,
                                      "nearest free point on the ground, relative to the robot"),
        field<&FreeGround::farPoint>(Unit::mm,
                                     "farthest free point on the ground, relative to the robot"),
        field<&FreeGround::farOnBorder>("whether the far point lies on the image border")};
  }
};

/// The free space around the robot as seen in one image, from left to right (report 3.2.7).
/// Provided by the ImageProcessor.
struct ObstaclesPercept {
  Time time;
  std::vector<FreeGround> lines;

  static constexpr auto fields() {
    return Fields{field<&ObstaclesPercept::time>(Unit::ms, "time of the image"),
                  field<&ObstaclesPercept::lines>()};
  }
};

}  // namespace gt
