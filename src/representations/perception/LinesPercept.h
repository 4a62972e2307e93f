#pragma once
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// What an edge on the field is an edge of (report 3.2.2, 3.3.3.1).
enum class EdgeType { line, border, yellowGoal, skyblueGoal };

/// Points on edges seen in one image, on the ground and relative to the robot (report 3.2.2).
/// Provided by the ImageProcessor.
struct LinesPercept {
  Time time;
  EnumArray<EdgeType, std::vector<Vector2d>> points;

  static constexpr auto fields() {
    return Fields{field<&LinesPercept::time>(Unit::ms, "of the image"),
                  field<&LinesPercept::points>(Unit::mm, "in the order of EdgeType")};
  }
};

}  // namespace gt
