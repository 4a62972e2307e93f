#pragma once

#include <string>
#include <vector>

#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The states that were active and the transitions that were taken, over any number of traces of
/// the same behavior.
class Coverage {
 public:
  explicit Coverage(const TraceSubject& subject);

  void add(const std::vector<TraceEvent>& events);

  /// One line for each state that was never active, and each transition of the others that was
  /// never taken, in the order of the sources. The sums follow.
  std::string report() const;

 private:
  /// A transition from a state, or from any state of an option: a branch of a decision that leads
  /// to a state.
  struct Way {
    int option = -1;
    int from = -1;  ///< -1: by the common decision tree
    int to = -1;
    int decision = -1;  ///< -1: without a condition
    bool held = true;   ///< whether its condition must hold
    long taken = 0;
  };

  void collect(Branch branch, int option, int from, int decision, bool held,
               std::vector<bool>& seen);
  std::string describe(const Way& way) const;

  const TraceSubject& subject_;
  std::vector<Way> ways_;
  std::vector<std::vector<std::size_t>> waysOfDecision_;
  std::vector<long> active_;  ///< cycles, by state
};

}  // namespace xabsl
