#pragma once
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The time of the present cycle of a process, one sample of the platform's clock. Provided by the
/// process.
struct FrameInfo {
  Time time;

  static constexpr auto fields() { return Fields{field<&FrameInfo::time>(Unit::ms)}; }
};

}  // namespace gt
