#include "xabsl/Warnings.h"

#include <algorithm>
#include <string>
#include <vector>

namespace xabsl {

namespace {

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

/// The states of one option and where their decisions lead.
class StateGraph {
 public:
  StateGraph(const Model& model, const Option& option, Reporter& reporter)
      : model_(model), option_(option), reporter_(reporter), targets_(at(option.states.count)) {
    for (int i = 0; i < option.states.count; ++i) {
      const Branch own = model.states[at(option.states.first + i)].decision;
      if (collect(option.commonDecision, i)) collect(own, i);
      std::vector<int>& targets = targets_[at(i)];
      std::sort(targets.begin(), targets.end());
      targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    }
  }

  void warn() {
    warnOfUnreachable();
    warnOfOscillation();
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

  void warnOfUnreachable() {
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
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (!reached[i])
        reporter_.warning(state(static_cast<int>(i)).location,
                          "state " + quoted(state(static_cast<int>(i)).name) + " of option " +
                              quoted(option_.name) + " is never entered");
  }

  /// The only state that follows, or -1 if the state may be kept or left in several ways.
  int onlySuccessor(int state) const {
    const std::vector<int>& targets = targets_[at(state)];
    return targets.size() == 1 && targets.front() != state ? targets.front() : -1;
  }

  void warnOfOscillation() {
    std::vector<int> walk(targets_.size(), -1);  // in which a state was visited
    for (int start = 0; start < option_.states.count; ++start) {
      int next = start;
      while (next >= 0 && walk[at(next)] < 0) {
        walk[at(next)] = start;
        next = onlySuccessor(next);
      }
      if (next >= 0 && walk[at(next)] == start) describeOscillation(next);
    }
  }

  void describeOscillation(int first) {
    constexpr int mostShown = 10;
    std::string path = state(first).name;
    int shown = 0;
    int next = first;
    do {
      next = onlySuccessor(next);
      if (++shown < mostShown) path += " -> " + state(next).name;
    } while (next != first);
    if (shown >= mostShown) path += " -> ...";
    reporter_.warning(state(first).location,
                      "states of option " + quoted(option_.name) + " can only oscillate: " + path);
  }

  const Model& model_;
  const Option& option_;
  Reporter& reporter_;
  std::vector<std::vector<int>> targets_;  // per state, counted from the first of the option
};

/// What calls set and what they leave out.
class ParameterUse {
 public:
  ParameterUse(const Model& model, Reporter& reporter)
      : model_(model), reporter_(reporter), set_(model.options.size()) {
    for (std::size_t i = 0; i < set_.size(); ++i)
      set_[i].resize(model.options[i].parameters.size());
  }

  void warn() {
    std::vector<bool> called(model_.options.size(), false);
    for (const Action& action : model_.actions) {
      if (action.kind == Action::Kind::assignment) continue;
      const bool option = action.kind == Action::Kind::option;
      if (option) called[at(action.target)] = true;
      const std::string& name = option ? model_.options[at(action.target)].name
                                       : model_.behaviors[at(action.target)].name;
      check(option ? model_.options[at(action.target)].parameters
                   : model_.behaviors[at(action.target)].parameters,
            action.operand, action.location,
            (option ? "option " : "basic behavior ") + quoted(name),
            option ? &set_[at(action.target)] : nullptr);
    }
    for (std::size_t i = 0; i < model_.expressions.size(); ++i) {
      const Expression& expression = model_.expressions[i];
      if (expression.operation != Operator::input) continue;
      const Symbol& symbol = model_.symbols[at(expression.a)];
      check(symbol.parameters, expression.b, model_.expressionLocations[i],
            "input symbol " + quoted(symbol.name), nullptr);
    }
    for (std::size_t i = 0; i < set_.size(); ++i)
      if (called[i]) warnOfNeverSet(model_.options[i], set_[i]);
  }

 private:
  void check(const std::vector<Parameter>& parameters, int first, Location location,
             const std::string& callee, std::vector<bool>* set) {
    std::vector<bool> given(parameters.size(), false);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const int parameter = model_.argumentOrder[at(first) + i];
      if (parameter < 0) break;
      given[at(parameter)] = true;
      if (set) (*set)[at(parameter)] = true;
    }
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (!given[i])
        reporter_.warning(location, "parameter " + quoted(parameters[i].name) + " of " + callee +
                                        " is not set, it is " + initial(parameters[i].type));
  }

  std::string initial(Type type) const {
    if (type.kind == ValueKind::number) return "0";
    if (type.kind == ValueKind::boolean) return "false";
    return quoted(model_.enumerations[at(type.enumeration)].elements.front().name);
  }

  void warnOfNeverSet(const Option& option, const std::vector<bool>& set) {
    for (std::size_t i = 0; i < set.size(); ++i)
      if (!set[i])
        reporter_.warning(option.parameters[i].location,
                          "parameter " + quoted(option.parameters[i].name) + " of option " +
                              quoted(option.name) + " is never set");
  }

  const Model& model_;
  Reporter& reporter_;
  std::vector<std::vector<bool>> set_;  // per option and parameter: by any call
};

void warnOfUnusedOptions(const Model& model, Reporter& reporter) {
  std::vector<bool> used(model.options.size(), false);
  std::vector<int> open;
  const auto use = [&](int option) {
    if (used[at(option)]) return;
    used[at(option)] = true;
    open.push_back(option);
  };
  const auto useCallees = [&](Span span) {
    for (int i = span.first; i < span.first + span.count; ++i)
      if (model.actions[at(i)].kind == Action::Kind::option) use(model.actions[at(i)].target);
  };
  for (const Agent& agent : model.agents) use(agent.rootOption);
  while (!open.empty()) {
    const Option& option = model.options[at(open.back())];
    open.pop_back();
    useCallees(option.commonActions);
    for (int i = 0; i < option.states.count; ++i)
      useCallees(model.states[at(option.states.first + i)].actions);
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      reporter.warning(model.options[i].location,
                       "option " + quoted(model.options[i].name) + " is not reached by any agent");
}

void warnOfUnusedDeclarations(const Model& model, Reporter& reporter) {
  for (const Symbol& symbol : model.symbols) {
    if (symbol.firstUse.option >= 0) continue;
    const std::string kind = symbol.kind == SymbolKind::input    ? "input"
                             : symbol.kind == SymbolKind::output ? "output"
                                                                 : "internal";
    reporter.warning(symbol.location, kind + " symbol " + quoted(symbol.name) + " is never used");
  }
  for (const BasicBehavior& behavior : model.behaviors)
    if (behavior.firstUse.option < 0)
      reporter.warning(behavior.location,
                       "basic behavior " + quoted(behavior.name) + " is never used");
}

}  // namespace

void warnAbout(const Model& model, Reporter& reporter) {
  for (const Option& option : model.options) StateGraph(model, option, reporter).warn();
  ParameterUse(model, reporter).warn();
  warnOfUnusedOptions(model, reporter);
  warnOfUnusedDeclarations(model, reporter);
}

}  // namespace xabsl
