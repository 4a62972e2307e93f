#pragma once
#include <vector>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The places on the field that a robot shall visit in the localization challenge (report 4.2).
/// Configuration, from `targets.cfg`.
struct TargetPoints {
  std::vector<Vector2d> points;

  static constexpr auto fields() {
    return Fields{field<&TargetPoints::points>(Unit::mm, "points to visit, on the field")};
  }
};

}  // namespace gt
