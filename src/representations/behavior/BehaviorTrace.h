#pragma once
#include <string>

#include "streams/Reflection.h"

namespace gt {

/// A part of a trace file, as `xabsl trace` reads it: the decisions of the behavior and their
/// causes. All parts of a log, concatenated, are the file (`gtlog export LOG OUT.trace`). Sent by
/// BehaviorControl while its debug key `BehaviorControl/trace` is active.
struct BehaviorTrace {
  std::string text;

  static constexpr auto fields() {
    return Fields{
        field<&BehaviorTrace::text>("part of a trace file; format: see xabsl/trace/TraceFile.h")};
  }
};

}  // namespace gt
