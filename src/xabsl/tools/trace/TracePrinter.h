#pragma once

#include <string>

#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// Whether something happened in a cycle: a transition, or a path that differs from that of the
/// cycle before, which ends where this one begins (null: there is none).
bool isEventful(const TraceEvent* first, const TraceEvent* last, const TraceEvent* before);

/// A cycle for people: what was active, indented by depth; below an option that changed its state
/// the conditions that it asked, whether each held, and the values that were read. With `all` the
/// conditions of the other options, too.
std::string printCycle(const TraceSubject& subject, const TraceEvent* first, const TraceEvent* last,
                       bool all = false);

}  // namespace xabsl
