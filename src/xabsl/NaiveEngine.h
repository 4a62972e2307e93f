#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "xabsl/Model.h"
#include "xabsl/VirtualSymbols.h"

namespace xabsl::test {

/// A second engine, which reads a model as directly as it can be read: everything is looked up, and
/// nothing is prepared. The real one must do the same. Runs in the surroundings of VirtualSymbols,
/// whose call it is given, and alone in its team.
class NaiveEngine {
 public:
  struct Step {
    bool option;
    int index;
    int state;
    std::int64_t optionTime;
    std::int64_t stateTime;
    std::vector<double> parameters;
  };

  NaiveEngine(const Model& model, VirtualSymbols& world, VirtualSymbols::Call call)
      : model_(model), world_(world), call_(std::move(call)) {
    for (std::size_t i = 0; i < model.symbols.size(); ++i) variables_[static_cast<int>(i)] = 0;
  }

  /// What was executed, in its order.
  std::vector<Step> execute(std::int64_t now) {
    steps_.clear();
    now_ = now;
    run(model_.agents[0].rootOption, {});
    wasActive_ = std::exchange(isActive_, {});
    return steps_;
  }

  double variable(int symbol) const { return variables_.at(symbol); }

 private:
  struct Memory {
    int state = -1;
    std::int64_t began = 0;
    std::int64_t stateBegan = 0;
    std::vector<double> parameters;
  };

  template <typename T>
  static const T& in(const std::vector<T>& list, int index) {
    return list.at(static_cast<std::size_t>(index));
  }

  void run(int index, std::vector<double> parameters) {
    const Option& option = in(model_.options, index);
    Memory& memory = memories_[index];
    memory.parameters = std::move(parameters);
    if (!wasActive_.count(index)) memory = {option.initialState, now_, now_, memory.parameters};
    isActive_.insert(index);
    Branch end = follow(option.commonDecision, index);
    if (end.kind == Branch::Kind::none)
      end = follow(in(model_.states, memory.state).decision, index);
    if (end.kind == Branch::Kind::state && end.index != memory.state && mayEnter(end.index)) {
      memory.state = end.index;
      memory.stateBegan = now_;
    }
    steps_.push_back({true, index, memory.state, now_ - memory.began, now_ - memory.stateBegan,
                      memory.parameters});
    const int state = memory.state;
    act(option.commonActions, index);
    act(in(model_.states, state).actions, index);
  }

  /// Alone one may enter what has room for one, and what one alone is enough for.
  bool mayEnter(int state) const {
    const Cooperation& cooperation = in(model_.states, state).cooperation;
    if (cooperation.kind == Cooperation::Kind::capacity) return cooperation.agents > 0;
    return cooperation.kind == Cooperation::Kind::none || cooperation.agents <= 1;
  }

  Branch follow(Branch branch, int option) {
    if (branch.kind != Branch::Kind::decision) return branch;
    const Decision& decision = in(model_.decisions, branch.index);
    return follow(value(decision.condition, option) != 0 ? decision.then : decision.otherwise,
                  option);
  }

  void act(Span span, int option) {
    for (int i = span.first; i < span.first + span.count; ++i) {
      const Action& action = in(model_.actions, i);
      if (action.kind == Action::Kind::assignment) {
        variables_[action.target] = value(action.operand, option);
        continue;
      }
      const bool isOption = action.kind == Action::Kind::option;
      const auto& declared = isOption ? in(model_.options, action.target).parameters
                                      : in(model_.behaviors, action.target).parameters;
      std::vector<double> parameters;
      for (std::size_t p = 0; p < declared.size(); ++p)
        parameters.push_back(
            value(in(model_.operands, action.operand + static_cast<int>(p)), option));
      if (isOption)
        run(action.target, parameters);
      else
        steps_.push_back({false, action.target, -1, 0, 0, parameters});
    }
  }

  bool actionDone(int option) {
    for (const Span& span : {in(model_.options, option).commonActions,
                             in(model_.states, memories_[option].state).actions})
      for (int i = span.first; i < span.first + span.count; ++i) {
        const Action& action = in(model_.actions, i);
        if (action.kind == Action::Kind::option && wasActive_.count(action.target) &&
            in(model_.states, memories_[action.target].state).target)
          return true;
      }
    return false;
  }

  double input(const Expression& expression, int option) {
    const std::size_t count = in(model_.symbols, expression.a).parameters.size();
    if (count == 0) return world_.value(expression.a);
    std::vector<double> arguments;
    for (std::size_t p = 0; p < count; ++p)
      arguments.push_back(value(in(model_.operands, expression.b + static_cast<int>(p)), option));
    return call_(expression.a, arguments.data());
  }

  double value(int index, int option) {
    const Expression& e = in(model_.expressions, index);
    const auto a = [&] { return value(e.a, option); };
    const auto b = [&] { return value(e.b, option); };
    const Memory& memory = memories_[option];
    switch (e.operation) {
      case Operator::constant:
        return e.number;
      case Operator::element:
        return e.b;
      case Operator::parameter:
        return memory.parameters.at(static_cast<std::size_t>(e.b));
      case Operator::input:
        return input(e, option);
      case Operator::variable:
        return variables_.at(e.a);
      case Operator::stateTime:
        return static_cast<double>(now_ - memory.stateBegan);
      case Operator::optionTime:
        return static_cast<double>(now_ - memory.began);
      case Operator::actionDone:
        return actionDone(option);
      case Operator::conflict:
        return false;
      case Operator::negate:
        return -a();
      case Operator::logicalNot:
        return a() == 0;
      case Operator::conditional:
        return value(a() != 0 ? e.b : e.c, option);
      case Operator::logicalAnd:
      case Operator::logicalOr:
        for (int i = e.b; i < e.b + e.c; ++i)
          if ((value(in(model_.operands, i), option) != 0) == (e.operation == Operator::logicalOr))
            return e.operation == Operator::logicalOr;
        return e.operation == Operator::logicalAnd;
      default:
        return binary(e.operation, a(), b());
    }
  }

  static double binary(Operator operation, double a, double b) {
    switch (operation) {
      case Operator::add:
        return a + b;
      case Operator::subtract:
        return a - b;
      case Operator::multiply:
        return a * b;
      case Operator::divide:
        return a / (b == 0 ? 1e-7 : b);
      case Operator::modulo:
        return std::trunc(b) == 0 ? 0 : std::fmod(std::trunc(a), std::trunc(b));
      case Operator::equal:
        return a == b;
      case Operator::notEqual:
        return a != b;
      case Operator::less:
        return a < b;
      case Operator::lessEqual:
        return a <= b;
      case Operator::greater:
        return a > b;
      case Operator::greaterEqual:
        return a >= b;
      default:
        return std::nan("");
    }
  }

  const Model& model_;
  VirtualSymbols& world_;
  VirtualSymbols::Call call_;
  std::map<int, double> variables_;
  std::map<int, Memory> memories_;
  std::set<int> wasActive_, isActive_;
  std::vector<Step> steps_;
  std::int64_t now_ = 0;
};

}  // namespace xabsl::test
