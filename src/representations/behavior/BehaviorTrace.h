#pragma once
#include <string>

#include "streams/Reflection.h"

namespace gt {

/// What the behavior did, and why: a part of a trace file, as `xabsl trace` reads it. All parts of
/// a log, one after another, are the file (`gtlog export LOG OUT.trace`). Sent by BehaviorControl
/// while its debug key `BehaviorControl/trace` is active.
struct BehaviorTrace {
  std::string text;

  static constexpr auto fields() {
    return Fields{field<&BehaviorTrace::text>("see xabsl/trace/TraceFile.h")};
  }
};

}  // namespace gt
