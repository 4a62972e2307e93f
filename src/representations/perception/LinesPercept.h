#pragma once
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// Types of edges on the field (report 3.2.2, 3.3.3.1).
enum class EdgeType { line, border, yellowGoal, skyblueGoal };

/// Points on edges seen in one image, on the ground and relative to the robot (report 3.2.2).
/// Provided by the ImageProcessor.
struct LinesPercept {
  Time time;
  EnumArray<EdgeType, std::vector<Vector2d>> points;

  static constexpr auto fields() {
    return Fields{
        field<&LinesPercept::time>(Unit::ms, "time of the image"),
        field<&LinesPercept::points>(
            Unit::mm, "points on the ground, relative to the robot, in the order of EdgeType")};
  }
};

}  // namespace gt
