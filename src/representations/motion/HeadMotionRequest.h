#pragma once
#include "streams/Reflection.h"

namespace gt {

/// The angles that the head shall take. Provided by HeadControl.
struct HeadMotionRequest {
  double tilt = 0;
  double pan = 0;
  double roll = 0;
  double mouth = 0;

  static constexpr auto fields() {
    return Fields{field("tilt", &HeadMotionRequest::tilt, "rad"),
                  field("pan", &HeadMotionRequest::pan, "rad"),
                  field("roll", &HeadMotionRequest::roll, "rad"),
                  field("mouth", &HeadMotionRequest::mouth, "rad")};
  }
};

}  // namespace gt
