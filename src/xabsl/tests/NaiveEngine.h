#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "xabsl/engine/TraceRecorder.h"
#include "xabsl/engine/VirtualSymbols.h"
#include "xabsl/language/Model.h"

namespace xabsl::test {

/// A second engine, which interprets a model as directly as possible, without any preparation. The
/// real engine must behave in the same way and record the same events. Uses the functions of
/// VirtualSymbols, whose call it is given.
class NaiveEngine {
 public:
  /// The message of teammates to one another: states by their indices.
  struct Message {
    double priority = 0;
    std::set<int> executed, entering, options;
  };

  struct Step {
    bool option;
    int index;
    int state;
    std::int64_t optionTime;
    std::int64_t stateTime;
    std::vector<double> parameters;
  };

  NaiveEngine(const Model& model, VirtualSymbols& world, VirtualSymbols::Call call, double priority,
              int synchronizationTicks)
      : model_(model),
        world_(world),
        call_(std::move(call)),
        priority_(priority),
        synchronizationTicks_(synchronizationTicks) {
    for (std::size_t i = 0; i < model.symbols.size(); ++i) variables_[static_cast<int>(i)] = 0;
  }

  /// Returns the executed steps, in their order.
  std::vector<Step> execute(std::int64_t now, const std::vector<Message>& heard) {
    steps_.clear();
    events_.clear();
    heard_ = heard;
    for (auto& [state, cycles] : announced_) cycles = entering_.count(state) ? cycles + 1 : 0;
    for (const int state : entering_) announced_.try_emplace(state, 1);
    entering_.clear();
    message_ = {priority_, {}, {}, {}};
    now_ = now;
    note(TraceEvent::Kind::cycle, 0, static_cast<double>(now));
    run(model_.agents[0].rootOption, {}, 0);
    wasActive_ = std::exchange(isActive_, {});
    return steps_;
  }

  /// The events of the last cycle.
  const std::vector<TraceEvent>& events() const { return events_; }
  const Message& message() const { return message_; }

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

  void note(TraceEvent::Kind kind, int index, double value) {
    events_.push_back({kind, index, value});
  }
  void noteParameters(const std::vector<double>& parameters) {
    for (std::size_t p = 0; p < parameters.size(); ++p)
      note(TraceEvent::Kind::parameter, static_cast<int>(p), parameters[p]);
  }

  void run(int index, std::vector<double> parameters, int depth) {
    const Option& option = in(model_.options, index);
    Memory& memory = memories_[index];
    memory.parameters = std::move(parameters);
    if (!wasActive_.count(index)) memory = {option.initialState, now_, now_, memory.parameters};
    isActive_.insert(index);
    note(TraceEvent::Kind::option, index, depth);
    Branch end = follow(option.commonDecision, index);
    if (end.kind == Branch::Kind::none)
      end = follow(in(model_.states, memory.state).decision, index);
    if (end.kind == Branch::Kind::state && end.index != memory.state &&
        mayEnter(index, end.index)) {
      note(TraceEvent::Kind::change, memory.state, end.index);
      memory.state = end.index;
      memory.stateBegan = now_;
    }
    informTeam(option, index);
    noteStep(index);
    const int state = memory.state;
    act(option.commonActions, index, depth);
    act(in(model_.states, state).actions, index, depth);
  }

  void informTeam(const Option& option, int index) {
    message_.options.insert(index);
    const int active = memories_[index].state;
    for (const int s : option.states) {
      message_.executed.erase(s);
      message_.entering.erase(s);
      if (s == active)
        message_.executed.insert(s);
      else if (entering_.count(s))
        message_.entering.insert(s);
    }
  }

  void noteStep(int index) {
    const Memory& memory = memories_[index];
    const Step step{true,
                    index,
                    memory.state,
                    now_ - memory.began,
                    now_ - memory.stateBegan,
                    memory.parameters};
    note(TraceEvent::Kind::state, step.state, static_cast<double>(step.stateTime));
    note(TraceEvent::Kind::optionTime, index, static_cast<double>(step.optionTime));
    noteParameters(step.parameters);
    steps_.push_back(step);
  }

  /// Decides as the engines of other teams do, by the received messages.
  bool mayEnter(int option, int state) {
    const Cooperation& cooperation = in(model_.states, state).cooperation;
    if (cooperation.kind == Cooperation::Kind::none) return true;
    std::vector<double> entering;
    int inOption = 0, executing = 0;
    for (const Message& other : heard_) {
      inOption += other.options.count(option) > 0;
      executing += other.executed.count(state) > 0;
      if (other.entering.count(state)) entering.push_back(other.priority);
    }
    const auto wanting = executing + static_cast<int>(entering.size());
    if (cooperation.kind == Cooperation::Kind::synchronized) {
      entering_.insert(state);
      return inOption + 1 >= cooperation.agents && wanting == inOption &&
             announced_[state] > synchronizationTicks_ / 2;
    }
    if (executing < cooperation.agents && wanting >= cooperation.agents) {
      const double rival = *std::max_element(entering.begin(), entering.end());
      if (rival == priority_) {
        entering_.erase(state);
        return false;
      }
      if (rival > priority_) executing = cooperation.agents;
    }
    const bool agreed =
        executing < cooperation.agents && announced_[state] >= synchronizationTicks_;
    if (agreed)
      entering_.erase(state);
    else
      entering_.insert(state);
    return agreed;
  }

  bool conflict(int state) const {
    const Cooperation& cooperation = in(model_.states, state).cooperation;
    int executing = 0;
    for (const Message& other : heard_) executing += other.executed.count(state) > 0;
    return cooperation.kind == Cooperation::Kind::capacity && executing >= cooperation.agents;
  }

  Branch follow(Branch branch, int option) {
    if (branch.kind != Branch::Kind::decision) return branch;
    const Decision& decision = in(model_.decisions, branch.index);
    const bool holds = value(decision.condition, option) != 0;
    note(TraceEvent::Kind::decide, branch.index, holds);
    return follow(holds ? decision.then : decision.otherwise, option);
  }

  void act(Span span, int option, int depth) {
    for (const Action& action : span.of(model_.actions)) {
      if (action.kind == Action::Kind::assignment) {
        variables_[action.target] = value(action.operand, option);
        note(TraceEvent::Kind::assign, action.target, variables_[action.target]);
        continue;
      }
      const bool isOption = action.kind == Action::Kind::option;
      const auto& declared = isOption ? in(model_.options, action.target).parameters
                                      : in(model_.behaviors, action.target).parameters;
      std::vector<double> parameters;
      for (std::size_t p = 0; p < declared.size(); ++p)
        parameters.push_back(
            value(in(model_.operands, action.operand + static_cast<int>(p)), option));
      if (isOption) {
        run(action.target, parameters, depth + 1);
      } else {
        steps_.push_back({false, action.target, -1, 0, 0, parameters});
        note(TraceEvent::Kind::behavior, action.target, depth + 1);
        noteParameters(parameters);
      }
    }
  }

  bool actionDone(int option) {
    for (const Span& span : {in(model_.options, option).commonActions,
                             in(model_.states, memories_[option].state).actions})
      for (const Action& action : span.of(model_.actions)) {
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
    for (std::size_t p = 0; p < count; ++p)
      note(TraceEvent::Kind::argument, static_cast<int>(p), arguments[p]);
    return call_(expression.a, arguments.data());
  }

  double value(int index, int option) {
    const Expression& e = in(model_.expressions, index);
    const auto a = [&] { return value(e.a, option); };
    const auto b = [&] { return value(e.b, option); };
    const Memory& memory = memories_[option];
    const auto read = [&](double number) {
      note(TraceEvent::Kind::read, index, number);
      return number;
    };
    switch (e.operation) {
      case Operator::constant:
        return e.number;
      case Operator::element:
        return e.b;
      case Operator::parameter:
        return read(memory.parameters.at(static_cast<std::size_t>(e.b)));
      case Operator::input:
        return read(input(e, option));
      case Operator::variable:
        return read(variables_.at(e.a));
      case Operator::stateTime:
        return read(static_cast<double>(now_ - memory.stateBegan));
      case Operator::optionTime:
        return read(static_cast<double>(now_ - memory.began));
      case Operator::actionDone:
        return read(actionDone(option));
      case Operator::conflict:
        return read(conflict(memory.state));
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
      default: {
        const double left = a();
        return binary(e.operation, left, b());
      }
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
  double priority_;
  int synchronizationTicks_;
  Message message_;
  std::vector<Message> heard_;
  std::set<int> entering_;        ///< the states announced in this cycle
  std::map<int, int> announced_;  ///< of each state: number of consecutive cycles before
  std::map<int, double> variables_;
  std::map<int, Memory> memories_;
  std::set<int> wasActive_, isActive_;
  std::vector<Step> steps_;
  std::vector<TraceEvent> events_;
  std::int64_t now_ = 0;
};

}  // namespace xabsl::test
