#include "xabsl/language/OptionGraph.h"

#include <algorithm>
#include <string>
#include <vector>

namespace xabsl {

namespace {

/// Walks the options from the called ones up to the callers.
class GraphCheck {
 public:
  GraphCheck(Model& model, Reporter& reporter)
      : model_(model),
        reporter_(reporter),
        callees_(model.options.size()),
        weights_(model.options.size(), 0),
        lengths_(model.options.size(), 0) {}

  void run() {
    findCallees();
    const std::vector<int> order = calleesFirst();
    if (order.size() < model_.options.size()) return reportCycle(order);
    for (const int option : order) measure(option);
    for (std::size_t i = 0; i < weights_.size() && !reporter_.failed(); ++i) checkLimits(i);
  }

 private:
  void findCallees() {
    for (std::size_t i = 0; i < model_.options.size(); ++i) {
      const auto collect = [&](Span actions) {
        for (const Action& action : actions.of(model_.actions))
          if (action.kind == Action::Kind::option) callees_[i].push_back(&action);
      };
      const Option& option = model_.options[i];
      collect(option.commonActions);
      for (const State& state : option.states.of(model_.states)) collect(state.actions);
    }
  }

  /// Kahn's algorithm; what is on a cycle, or calls a cycle, is left out.
  std::vector<int> calleesFirst() const {
    std::vector<std::size_t> open(callees_.size());
    std::vector<std::vector<int>> callers(callees_.size());
    std::vector<int> order;
    for (std::size_t i = 0; i < callees_.size(); ++i) {
      open[i] = callees_[i].size();
      if (open[i] == 0) order.push_back(static_cast<int>(i));
      for (const Action* call : callees_[i])
        callers[at(call->target)].push_back(static_cast<int>(i));
    }
    for (std::size_t next = 0; next < order.size(); ++next)
      for (const int caller : callers[at(order[next])])
        if (--open[at(caller)] == 0) order.push_back(caller);
    return order;
  }

  void reportCycle(const std::vector<int>& order) {
    std::vector<bool> sound(callees_.size(), false);
    for (const int option : order) sound[at(option)] = true;
    // Whatever is left calls something else that is left: following the calls leads round the
    // cycle.
    std::size_t option = 0;
    while (sound[option]) ++option;
    std::vector<const Action*> path;
    std::vector<bool> visited(callees_.size(), false);
    while (!visited[option]) {
      visited[option] = true;
      const auto call =
          std::find_if(callees_[option].begin(), callees_[option].end(),
                       [&](const Action* action) { return !sound[at(action->target)]; });
      path.push_back(*call);
      option = static_cast<std::size_t>((*call)->target);
    }
    const int start = path.back()->target;
    std::string text = model_.options[option].name;
    auto step = std::find_if(path.begin(), path.end() - 1,
                             [&](const Action* action) { return action->target == start; });
    step = *step == path.back() ? path.begin() : step + 1;
    const Location location = (*step)->location;
    for (int shown = 0; step != path.end(); ++step, ++shown) {
      if (shown == 10) {
        text += " -> ...";
        break;
      }
      text += " -> " + model_.options[at((*step)->target)].name;
    }
    reporter_.error(location, "options call one another in a cycle: " + text);
  }

  std::size_t weight(Span span, int& length) const {
    std::size_t sum = 0;
    for (const Action& action : span.of(model_.actions)) {
      const std::size_t target = static_cast<std::size_t>(action.target);
      if (action.kind == Action::Kind::option) {
        sum += weights_[target];
        length = std::max(length, lengths_[target]);
      } else if (action.kind == Action::Kind::behavior) {
        sum += 1 + model_.behaviors[target].parameters.size();
      }
      sum = std::min(sum, maximalActivation + 1);
    }
    return sum;
  }

  void measure(int index) {
    const Option& option = model_.options[at(index)];
    int length = 0;
    const std::size_t common = weight(option.commonActions, length);
    std::size_t largest = 0;
    for (const State& state : option.states.of(model_.states))
      largest = std::max(largest, weight(state.actions, length));
    const std::size_t total = 1 + option.parameters.size() + common + largest;
    weights_[at(index)] = std::min(total, maximalActivation + 1);
    lengths_[at(index)] = length + 1;
  }

  void checkLimits(std::size_t index) {
    const Option& option = model_.options[index];
    if (weights_[index] > maximalActivation)
      reporter_.error(option.location, "option " + option.name + " may execute more than " +
                                           std::to_string(maximalActivation) +
                                           " options and behaviors in a cycle");
    else if (lengths_[index] > maximalPath)
      reporter_.error(option.location, "the path of options from " + option.name +
                                           " is longer than " + std::to_string(maximalPath));
    model_.largestActivation = std::max(model_.largestActivation, weights_[index]);
  }

  Model& model_;
  Reporter& reporter_;
  std::vector<std::vector<const Action*>> callees_;
  std::vector<std::size_t> weights_;  // options, behaviors and parameters in one cycle, at most
  std::vector<int> lengths_;          // of the longest path from here down
};

}  // namespace

void checkOptionGraph(Model& model, Reporter& reporter) {
  GraphCheck(model, reporter).run();
}

}  // namespace xabsl
