#include "xabsl/language/Warnings.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/language/ModelText.h"

namespace xabsl {

namespace {

/// The graph of the states of one option and their transitions.
class StateGraph {
 public:
  StateGraph(const Model& model, const Option& option)
      : model_(model), option_(option), targets_(at(option.states.count)) {
    for (int i = 0; i < option.states.count; ++i) {
      const Branch own = model.states[at(option.states.first + i)].decision;
      if (collect(option.commonDecision, i)) collect(own, i);
      std::vector<int>& targets = targets_[at(i)];
      std::sort(targets.begin(), targets.end());
      targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    }
  }

  /// Whether each state can be reached from the initial one.
  std::vector<bool> entered() const {
    std::vector<bool> reached(targets_.size(), false);
    std::vector<int> open = {option_.initialState - option_.states.first};
    reached[at(open.back())] = true;
    while (!open.empty()) {
      const int from = open.back();
      open.pop_back();
      for (const int to : targets_[at(from)]) {
        if (reached[at(to)]) continue;
        reached[at(to)] = true;
        open.push_back(to);
      }
    }
    return reached;
  }

  void warn(Reporter& reporter) const {
    warnOfUnreachable(reporter);
    warnOfOscillation(reporter);
  }

 private:
  /// Adds where a decision may lead from a state; true if it may decide nothing.
  bool collect(Branch branch, int state) {
    bool open = false;
    // In a loop, since chains of `else if` may be long.
    std::vector<Branch> pending = {branch};
    while (!pending.empty()) {
      branch = pending.back();
      pending.pop_back();
      if (branch.kind == Branch::Kind::decision) {
        pending.push_back(model_.decisions[at(branch.index)].then);
        pending.push_back(model_.decisions[at(branch.index)].otherwise);
      } else if (branch.kind == Branch::Kind::none) {
        open = true;
      } else {
        const bool stays = branch.kind == Branch::Kind::stay;
        targets_[at(state)].push_back(stays ? state : branch.index - option_.states.first);
      }
    }
    return open;
  }

  const State& state(int index) const { return model_.states[at(option_.states.first + index)]; }

  void warnOfUnreachable(Reporter& reporter) const {
    const std::vector<bool> entered = this->entered();
    for (std::size_t i = 0; i < entered.size(); ++i)
      if (!entered[i])
        reporter.warning(state(static_cast<int>(i)).location,
                         "state " + inQuotes(state(static_cast<int>(i)).name) + " of option " +
                             inQuotes(option_.name) + " is never entered");
  }

  /// The only state that follows, or -1 if the state may be kept or left in several ways.
  int onlySuccessor(int state) const {
    const std::vector<int>& targets = targets_[at(state)];
    return targets.size() == 1 && targets.front() != state ? targets.front() : -1;
  }

  void warnOfOscillation(Reporter& reporter) const {
    std::vector<int> walk(targets_.size(), -1);  // in which a state was visited
    for (int start = 0; start < option_.states.count; ++start) {
      int next = start;
      while (next >= 0 && walk[at(next)] < 0) {
        walk[at(next)] = start;
        next = onlySuccessor(next);
      }
      if (next >= 0 && walk[at(next)] == start) describeOscillation(next, reporter);
    }
  }

  void describeOscillation(int first, Reporter& reporter) const {
    constexpr int mostShown = 10;
    std::string path = state(first).name;
    int shown = 0;
    int next = first;
    do {
      next = onlySuccessor(next);
      if (++shown < mostShown) path += " -> " + state(next).name;
    } while (next != first);
    if (shown >= mostShown) path += " -> ...";
    reporter.warning(state(first).location,
                     "states of option " + inQuotes(option_.name) + " can only oscillate: " + path);
  }

  const Model& model_;
  const Option& option_;
  std::vector<std::vector<int>> targets_;  // per state, counted from the first of the option
};

/// The parameters that calls set and those that they leave out. Teams leave out many on purpose, so
/// each parameter is reported once.
class ParameterUse {
 public:
  ParameterUse(const Model& model, Reporter& reporter) : model_(model), reporter_(reporter) {
    for (const Option& option : model.options) options_.emplace_back(option.parameters.size());
    for (const BasicBehavior& behavior : model.behaviors)
      behaviors_.emplace_back(behavior.parameters.size());
    for (const Symbol& symbol : model.symbols) inputs_.emplace_back(symbol.parameters.size());
  }

  void warn() {
    count();
    for (std::size_t i = 0; i < options_.size(); ++i)
      warn(model_.options[i].parameters, options_[i], "option " + inQuotes(model_.options[i].name));
    for (std::size_t i = 0; i < behaviors_.size(); ++i)
      warn(model_.behaviors[i].parameters, behaviors_[i],
           "basic behavior " + inQuotes(model_.behaviors[i].name));
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      warn(model_.symbols[i].parameters, inputs_[i],
           "input symbol " + inQuotes(model_.symbols[i].name));
  }

 private:
  /// How often a parameter was set and left out.
  struct Count {
    int set = 0;
    int missing = 0;
    Location firstMissing;
  };
  using Counts = std::vector<Count>;

  void count() {
    for (const Action& action : model_.actions)
      if (action.kind != Action::Kind::assignment)
        count(action.operand, action.location,
              (action.kind == Action::Kind::option ? options_ : behaviors_)[at(action.target)]);
    for (std::size_t i = 0; i < model_.expressions.size(); ++i) {
      const Expression& expression = model_.expressions[i];
      if (expression.operation == Operator::input)
        count(expression.b, model_.expressionLocations[i], inputs_[at(expression.a)]);
    }
  }

  void count(int first, Location location, Counts& counts) {
    std::vector<bool> given(counts.size(), false);
    for (const int parameter : model_.setParameters(first, counts.size()))
      given[at(parameter)] = true;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (!given[i] && counts[i].missing == 0) counts[i].firstMissing = location;
      ++(given[i] ? counts[i].set : counts[i].missing);
    }
  }

  void warn(const std::vector<Parameter>& parameters, const Counts& counts,
            const std::string& callee) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (counts[i].missing == 0) continue;
      const std::string name = "parameter " + inQuotes(parameters[i].name) + " of " + callee;
      const std::string value = ", it is " + initial(parameters[i].type);
      const int others = counts[i].missing - 1;
      if (counts[i].set == 0)
        reporter_.warning(parameters[i].location, name + " is never set" + value);
      else
        reporter_.warning(counts[i].firstMissing,
                          name + " is not set" + value +
                              (others > 0 ? ", as in " + std::to_string(others) + " other " +
                                                (others == 1 ? "call" : "calls")
                                          : ""));
    }
  }

  std::string initial(Type type) const {
    if (type.kind == ValueKind::number) return "0";
    if (type.kind == ValueKind::boolean) return "false";
    return inQuotes(model_.enumerations[at(type.enumeration)].elements.front().name);
  }

  const Model& model_;
  Reporter& reporter_;
  std::vector<Counts> options_;
  std::vector<Counts> behaviors_;
  std::vector<Counts> inputs_;  // per symbol
};

struct Unused {
  int space;
  std::string kind;
  std::string name;
  Location location;
  std::string problem;
};

/// `'a', 'b' and 3 others`
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t mostShown = 6;
  const std::size_t shown = names.size() <= mostShown ? names.size() : mostShown - 1;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i > 0 && i + 1 == names.size();
    text += (last ? " and " : i > 0 ? ", " : "") + inQuotes(names[i]);
  }
  return shown < names.size() ? text + " and " + std::to_string(names.size() - shown) + " others"
                              : text;
}

/// Reports one warning for all unused declarations of one kind and namespace, because libraries of
/// symbols are made for more than one behavior.
void warnOfUnused(const std::vector<Unused>& all, Reporter& reporter) {
  std::map<std::pair<int, std::string>, std::vector<const Unused*>> groups;
  for (const Unused& unused : all) groups[{unused.space, unused.kind}].push_back(&unused);
  for (const auto& [key, group] : groups) {
    std::vector<std::string> names;
    for (const Unused* unused : group) names.push_back(unused->name);
    const bool several = names.size() > 1;
    reporter.warning(group.front()->location, key.second + (several ? "s " : " ") + listed(names) +
                                                  (several ? " are " : " is ") +
                                                  group.front()->problem);
  }
}

std::vector<Unused> unusedOptions(const Model& model) {
  std::vector<bool> used(model.options.size(), false);
  std::vector<int> open;
  const auto use = [&](int option) {
    if (used[at(option)]) return;
    used[at(option)] = true;
    open.push_back(option);
  };
  const auto useCallees = [&](Span span) {
    for (const Action& action : span.of(model.actions))
      if (action.kind == Action::Kind::option) use(action.target);
  };
  for (const Agent& agent : model.agents) use(agent.rootOption);
  while (!open.empty()) {
    const Option& option = model.options[at(open.back())];
    open.pop_back();
    useCallees(option.commonActions);
    for (const State& state : option.states.of(model.states)) useCallees(state.actions);
  }
  std::vector<Unused> unused;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      unused.push_back({-1, "option", model.options[i].name, model.options[i].location,
                        "not reached by any agent"});
  return unused;
}

std::vector<Unused> unusedDeclarations(const Model& model) {
  std::vector<Unused> unused;
  for (const Symbol& symbol : model.symbols) {
    const std::string kind = wordOf(symbol.kind);
    if (symbol.firstUse.option < 0)
      unused.push_back(
          {symbol.space, kind + " symbol", symbol.name, symbol.location, "never used"});
  }
  for (const BasicBehavior& behavior : model.behaviors)
    if (behavior.firstUse.option < 0)
      unused.push_back(
          {behavior.space, "basic behavior", behavior.name, behavior.location, "never used"});
  return unused;
}

/// Warns about options and basic behaviors that a state certainly executes more than once in each
/// cycle.
void warnOfRepeatedCalls(const Model& model, Reporter& reporter) {
  std::set<std::pair<Action::Kind, int>> called;
  const auto call = [&](Span actions, bool report) {
    for (const Action& action : actions.of(model.actions)) {
      if (action.kind == Action::Kind::assignment) continue;
      if (called.insert({action.kind, action.target}).second || !report) continue;
      const bool option = action.kind == Action::Kind::option;
      reporter.warning(action.location,
                       (option ? "option " : "basic behavior ") +
                           inQuotes(targetName(model, action)) +
                           " is executed twice in a cycle; some engines refuse such a behavior");
    }
  };
  for (const Option& option : model.options) {
    called.clear();
    call(option.commonActions, true);
    for (const State& state : option.states.of(model.states)) {
      called.clear();
      call(option.commonActions, false);
      call(state.actions, true);
    }
  }
}

}  // namespace

void warnAbout(const Model& model, Reporter& reporter) {
  for (const Option& option : model.options) StateGraph(model, option).warn(reporter);
  warnOfRepeatedCalls(model, reporter);
  ParameterUse(model, reporter).warn();
  warnOfUnused(unusedOptions(model), reporter);
  warnOfUnused(unusedDeclarations(model), reporter);
}

std::vector<bool> enteredStates(const Model& model, const Option& option) {
  return StateGraph(model, option).entered();
}

std::vector<Diagnostic> everythingUnused(const Model& model) {
  std::vector<Diagnostic> diagnostics;
  for (const std::vector<Unused>& list : {unusedOptions(model), unusedDeclarations(model)})
    for (const Unused& unused : list)
      diagnostics.push_back({Diagnostic::Severity::warning, model.files[at(unused.location.file)],
                             unused.location.line, unused.location.column,
                             unused.kind + " " + inQuotes(unused.name) + " is " + unused.problem});
  return diagnostics;
}

}  // namespace xabsl
