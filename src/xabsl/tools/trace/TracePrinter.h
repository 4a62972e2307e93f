#pragma once

#include <string>

#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// Whether a cycle has a transition, or a path of options that differs from that of the cycle
/// before. `before` is the beginning of the cycle before, which ends where this one begins; null if
/// there is none.
bool isEventful(const TraceEvent* first, const TraceEvent* last, const TraceEvent* before);

/// A cycle in readable form: the active options and basic behaviors, indented by depth. Below an
/// option that changed its state are the evaluated conditions, whether each held, and the values
/// that were read. With `all`, also the conditions of the other options.
std::string printCycle(const TraceSubject& subject, const TraceEvent* first, const TraceEvent* last,
                       bool all = false);

}  // namespace xabsl
