#pragma once

#include <map>
#include <utility>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The inputs recorded in a trace, cycle by cycle, for a behavior that may differ from the recorded
/// one: symbols are found by name, and the values of elements are their indices.
class Recording {
 public:
  Recording(std::vector<Trace> traces, const Model& model);

  void restart();
  /// Moves to the first cycle, then to the next. Returns false if there is none.
  bool nextCycle();
  double time() const { return time_; }
  double previousTime() const { return previousTime_; }

  /// The values read in this cycle, by input symbol without parameters.
  const std::vector<std::pair<int, double>>& inputs() const { return inputs_; }
  /// The value of an input symbol with parameters: the one for these arguments in this cycle,
  /// otherwise the last one.
  double call(int symbol, const double* arguments) const;

 private:
  /// The symbol of the model for a symbol of a trace.
  struct Place {
    int symbol = -1;  ///< -1: nothing
    std::vector<int> parameters;
  };
  struct Called {
    std::vector<double> arguments;
    double result = 0;
  };

  void findSymbols(const Trace& trace);
  Place place(const TraceSubject& subject, const Symbol& symbol) const;
  double translated(const TraceSubject& subject, Type from, Type to, double value) const;
  void take(const Trace& trace, const TraceEvent& event);

  std::vector<Trace> traces_;
  const Model& model_;
  std::vector<Place> places_;  ///< of the present trace
  std::size_t trace_ = 0;
  std::size_t event_ = 0;
  double time_ = 0;
  double previousTime_ = 0;
  std::map<int, double> arguments_;  ///< of the call that is being read
  std::vector<std::pair<int, double>> inputs_;
  std::map<int, std::vector<Called>> calls_;
  std::map<int, double> last_;
};

}  // namespace xabsl
