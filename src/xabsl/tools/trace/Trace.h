#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/engine/TraceRecorder.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// The recorded behavior, as far as the events of a trace refer to it, so that the behavior itself
/// is not needed to read the trace.
struct TraceSubject {
  /// A symbol, parameter or time that an expression reads.
  struct Read {
    std::string text;
    Type type;
    int symbol = -1;  ///< index into Model::symbols; -1: something else is read
  };
  struct Condition {
    std::string text;
    Location location;
  };

  Model model;                                     ///< without constants, actions and expressions
  std::vector<std::vector<double>> elementValues;  ///< per enumeration
  std::vector<Condition> conditions;               ///< per decision
  std::vector<Read> reads;  ///< per expression; an empty text: nothing is read

  /// The subject of an engine's behavior.
  static TraceSubject of(const Engine& engine);

  /// A value as text: `1.5`, `true` or the name of an element.
  std::string valueText(Type type, double value) const;
  /// `file:line`
  std::string place(Location location) const;
  const State& state(int index) const { return model.states[at(index)]; }
  /// The option that a state belongs to.
  int optionOf(int state) const;
};

/// The events of an engine while it executed one behavior. A file may contain several traces, if
/// the behavior was edited while it ran.
struct Trace {
  TraceSubject subject;
  std::vector<TraceEvent> events;  ///< begins with a cycle event, if there are any
};

/// Calls `visit(first, last)` with the events of each cycle.
template <typename Visit>
void forEachCycle(const std::vector<TraceEvent>& events, Visit visit) {
  const TraceEvent* const end = events.data() + events.size();
  for (const TraceEvent* first = events.data(); first != end;) {
    const TraceEvent* last = first + 1;
    while (last != end && last->kind != TraceEvent::Kind::cycle) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace xabsl
