#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The state of a behavior at the end of one cycle of a trace: the active options, and the last
/// values that were read or set of symbols.
class Moment {
 public:
  struct OptionMoment {
    int state = -1;     ///< -1: not active
    int previous = -1;  ///< in the cycle before
    double optionTime = 0;
    double stateTime = 0;
    std::vector<double> parameters;
  };
  struct BehaviorMoment {
    bool active = false;
    std::vector<double> parameters;
  };

  explicit Moment(const TraceSubject& subject);

  /// Advances to the next cycle by its events.
  void take(const TraceEvent* first, const TraceEvent* last);
  /// Sets the value of a symbol, as if it was read.
  void set(int symbol, double value) { symbols_[at(symbol)] = value; }

  double now() const { return now_; }
  /// The value of a symbol; nothing if it was neither read nor set yet.
  std::optional<double> symbol(int index) const { return symbols_[at(index)]; }
  const OptionMoment& option(int index) const { return options_[at(index)]; }
  const BehaviorMoment& behavior(int index) const { return behaviors_[at(index)]; }
  const TraceSubject& subject() const { return subject_; }

 private:
  const TraceSubject& subject_;
  double now_ = 0;
  std::vector<std::optional<double>> symbols_;
  std::vector<OptionMoment> options_;
  std::vector<BehaviorMoment> behaviors_;
};

}  // namespace xabsl
