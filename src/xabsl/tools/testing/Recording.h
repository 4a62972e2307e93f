#pragma once

#include <map>
#include <utility>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/tools/trace/Trace.h"

namespace xabsl {

/// The inputs that a trace recorded, cycle by cycle, for a behavior that may be another one:
/// symbols are found by name, and elements have their indices as values.
class Recording {
 public:
  Recording(std::vector<Trace> traces, const Model& model);

  void restart();
  /// Goes to the first cycle, then to the next; false: there is none.
  bool nextCycle();
  double time() const { return time_; }
  double previousTime() const { return previousTime_; }

  /// What was read in this cycle, by input symbol without parameters.
  const std::vector<std::pair<int, double>>& inputs() const { return inputs_; }
  /// What an input symbol with parameters yielded: for these arguments in this cycle, else what it
  /// yielded last.
  double call(int symbol, const double* arguments) const;

 private:
  /// What a symbol of a trace is in the model.
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
