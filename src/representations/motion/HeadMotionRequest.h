#pragma once
#include "streams/Reflection.h"

namespace gt {

/// The target angles of the head joints. Provided by HeadControl.
struct HeadMotionRequest {
  double tilt = 0;
  double pan = 0;
  double roll = 0;
  double mouth = 0;

  static constexpr auto fields() {
    return Fields{
        field<&HeadMotionRequest::tilt>(Unit::rad), field<&HeadMotionRequest::pan>(Unit::rad),
        field<&HeadMotionRequest::roll>(Unit::rad), field<&HeadMotionRequest::mouth>(Unit::rad)};
  }
};

}  // namespace gt
