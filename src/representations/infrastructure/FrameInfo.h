#pragma once
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The time of the process's present cycle, read from the platform's clock once per cycle. Provided
/// by the process.
struct FrameInfo {
  Time time;

  static constexpr auto fields() { return Fields{field<&FrameInfo::time>(Unit::ms)}; }
};

}  // namespace gt
