#pragma once
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/Player.h"
#include "streams/Reflection.h"

namespace gt {

/// The positions of robots seen in one image by the color of their tricots, on the ground relative
/// to the robot (report 3.2.6). Provided by the ImageProcessor.
struct PlayersPercept {
  Time time;
  EnumArray<TeamColor, std::vector<Vector2d>> players;

  static constexpr auto fields() {
    return Fields{field<&PlayersPercept::time>(Unit::ms, "time of the image"),
                  field<&PlayersPercept::players>(
                      Unit::mm, "positions relative to the robot, in the order of TeamColor")};
  }
};

}  // namespace gt
