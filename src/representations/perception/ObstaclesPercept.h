#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// A piece of free ground along one scan line (report 3.2): free between its points, an obstacle
/// behind the far one unless that lies on the border of the image, unknown before the near one.
/// Both are the same where the ground next to the robot is not free.
struct FreeGround {
  Vector2d nearPoint = Vector2d::Zero();
  Vector2d farPoint = Vector2d::Zero();
  bool farOnBorder = false;

  static constexpr auto fields() {
    return Fields{field<&FreeGround::nearPoint>(Unit::mm, "on the ground"),
                  field<&FreeGround::farPoint>(Unit::mm, "on the ground"),
                  field<&FreeGround::farOnBorder>("of the image")};
  }
};

/// The free space around the robot as seen in one image, from left to right (report 3.2.7).
/// Provided by the ImageProcessor.
struct ObstaclesPercept {
  Time time;
  std::vector<FreeGround> lines;

  static constexpr auto fields() {
    return Fields{field<&ObstaclesPercept::time>(Unit::ms, "of the image"),
                  field<&ObstaclesPercept::lines>()};
  }
};

}  // namespace gt
