#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace xabsl {

/// An event in an engine. Index and value depend on the kind:
struct TraceEvent {
  enum class Kind : std::uint8_t {
    cycle,       ///< value: the time in ms
    option,      ///< an option begins to decide; index: option, value: depth
    read,        ///< index: expression, value: its value
    argument,    ///< argument of the next read, of a function; index: parameter
    decide,      ///< index: decision, value: 1 if its condition held
    change,      ///< a transition; index: old state, value: new state
    state,       ///< an option has decided; index: state, value: ms since it became active
    optionTime,  ///< of the option before; index: option, value: ms since it became active
    behavior,    ///< index: basic behavior, value: depth
    parameter,   ///< of the option or basic behavior before; index: parameter
    assign       // index: output or internal symbol
  };
  static constexpr int kinds = 11;

  Kind kind = Kind::cycle;
  int index = 0;
  double value = 0;

  bool operator==(const TraceEvent&) const = default;
};

/// Keeps the events of an engine's last cycles in a ring buffer that is allocated once. New events
/// replace the oldest ones.
class TraceRecorder {
 public:
  /// `events` is the capacity. A cycle has about ten events for each active option.
  explicit TraceRecorder(std::size_t events) : ring_(events < 1 ? 1 : events) {}

  void add(TraceEvent::Kind kind, int index, double value) {
    ring_[next_] = {kind, index, value};
    if (++next_ == ring_.size()) next_ = 0;
    if (count_ < ring_.size()) ++count_;
  }

  /// The recorded events, oldest first, from the first complete cycle on.
  std::vector<TraceEvent> events() const {
    std::vector<TraceEvent> events;
    for (std::size_t i = 0; i < count_; ++i) {
      const TraceEvent& event = ring_[(next_ + ring_.size() - count_ + i) % ring_.size()];
      if (!events.empty() || event.kind == TraceEvent::Kind::cycle) events.push_back(event);
    }
    return events;
  }

  void clear() { count_ = 0; }

 private:
  std::vector<TraceEvent> ring_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace xabsl
