#include "xabsl/engine/Program.h"

#include <utility>

namespace xabsl {

namespace {

/// The target of jumps that is not known yet.
struct Label {
  std::vector<int> jumps;
};

class ProgramWriter {
 public:
  ProgramWriter(const Model& model, const Bindings& bindings, const MemoryLayout& layout,
                const double* memory, bool recorded)
      : model_(model), bindings_(bindings), layout_(layout), memory_(memory), recorded_(recorded) {}

  Program run() {
    program_.code.reserve(model_.expressions.size() + model_.actions.size());
    program_.states.resize(model_.states.size());
    emit(Operation::back);
    for (std::size_t i = 0; i < model_.options.size(); ++i) option(static_cast<int>(i));
    return std::move(program_);
  }

 private:
  // Options. Actions are written first, so that decisions know where to go on.

  void option(int index) {
    const Option& option = model_.options[at(index)];
    const bool common =
        option.commonDecision.kind != Branch::Kind::none || option.commonActions.count > 0;
    const int act = next();
    if (common) {
      beginActing(option, index);
      actions(option.commonActions);
      emit(Operation::actInState);
    }
    for (const int s : option.states) {
      Program::StateCode& code = program_.states[at(s)];
      code.actInState = next();
      code.act = common ? act : next();
      if (!common) beginActing(option, index);
      actions(model_.states[at(s)].actions);
      emit(Operation::back);
    }
    decisions(option, index, act);
  }

  void decisions(const Option& option, int index, int commonAct) {
    const bool common = option.commonDecision.kind != Branch::Kind::none;
    const int decideFirst = next();
    if (common) {
      beginDeciding(index);
      decide(option.commonDecision, commonAct);
    }
    for (const int s : option.states) {
      Program::StateCode& code = program_.states[at(s)];
      code.decideInState = next();
      code.decide = common ? decideFirst : next();
      if (!common) beginDeciding(index);
      decide(model_.states[at(s)].decision, code.act);
    }
  }

  void beginDeciding(int option) {
    if (recorded_) emit(Operation::recordOption).index = option;
  }

  void beginActing(const Option& option, int index) {
    if (cooperates(option)) emit(Operation::markOption).index = index;
    if (recorded_) emit(Operation::recordState).index = index;
    keepParameters(layout_.optionParameters[at(index)], option.parameters.size());
  }

  bool cooperates(const Option& option) const {
    for (const State& state : option.states.of(model_.states))
      if (state.cooperation.kind != Cooperation::Kind::none) return true;
    return false;
  }

  void keepParameters(int first, std::size_t count) {
    if (count > 0) emit(Operation::keepParameters, 0, place(first)).index = static_cast<int>(count);
  }

  // Decisions

  /// A chain of else branches may be long: it is written in a loop. `act`: where to go on if the
  /// state stays as it is.
  void decide(Branch branch, int act) {
    while (branch.kind == Branch::Kind::decision) {
      const Decision& decision = model_.decisions[at(branch.index)];
      Label otherwise;
      jumpIf(false, decision.condition, otherwise);
      if (recorded_) emit(Operation::recordHolds).index = branch.index;
      decide(decision.then, act);
      bind(otherwise);
      if (recorded_) emit(Operation::recordHoldsNot).index = branch.index;
      branch = decision.otherwise;
    }
    end(branch, act);
  }

  void end(Branch branch, int act) {
    if (branch.kind == Branch::Kind::none) {
      emit(Operation::decideInState);
    } else if (branch.kind == Branch::Kind::stay) {
      emit(Operation::stay, act);
    } else {
      const bool alone =
          model_.states[at(branch.index)].cooperation.kind == Cooperation::Kind::none;
      emit(alone ? Operation::change : Operation::changeIfAgreed,
           program_.states[at(branch.index)].act)
          .index = branch.index;
    }
  }

  // Conditions

  /// Jumps where a condition's truth is the one wanted, else goes on behind what is written here.
  void jumpIf(bool wanted, int condition, Label& label) {
    const Expression& expression = model_.expressions[at(condition)];
    switch (expression.operation) {
      case Operator::constant:
        if ((expression.number != 0) == wanted) jump(Operation::jump, label);
        return;
      case Operator::logicalNot:
        return jumpIf(!wanted, expression.a, label);
      case Operator::logicalAnd:
      case Operator::logicalOr:
        return jumpIfOperands(wanted, expression, label);
      case Operator::equal:
        return compare(wanted ? Operation::ifEqual : Operation::ifNotEqual, expression, label);
      case Operator::notEqual:
        return compare(wanted ? Operation::ifNotEqual : Operation::ifEqual, expression, label);
      case Operator::less:
      case Operator::greater:
        return compare(wanted ? Operation::ifLess : Operation::ifNotLess, expression, label);
      case Operator::lessEqual:
      case Operator::greaterEqual:
        return compare(wanted ? Operation::ifLessEqual : Operation::ifNotLessEqual, expression,
                       label);
      default:
        jump(wanted ? Operation::ifTrue : Operation::ifFalse, label, value(condition));
    }
  }

  /// The first operand that settles the whole is the last one that is asked.
  void jumpIfOperands(bool wanted, const Expression& expression, Label& label) {
    const bool settling = expression.operation == Operator::logicalOr;
    Label end;
    Label& settled = settling == wanted ? label : end;
    const int last = expression.b + expression.c - 1;
    for (int i = expression.b; i < last; ++i) jumpIf(settling, model_.operands[at(i)], settled);
    jumpIf(wanted, model_.operands[at(last)], label);
    bind(end);
  }

  void compare(Operation operation, const Expression& expression, Label& label) {
    auto [left, right] = operands(expression);
    const bool swapped =
        expression.operation == Operator::greater || expression.operation == Operator::greaterEqual;
    if (swapped) std::swap(left, right);
    jump(operation, label, left, right);
  }

  // Values

  const double* place(int index) const { return memory_ + index; }

  /// Where a value is found, once what is written here was executed.
  const double* value(int index) {
    const double* found = readable(index);
    if (!found) {
      compute(index, index);
      return place(index);
    }
    const Operator operation = model_.expressions[at(index)].operation;
    if (operation != Operator::constant && operation != Operator::element) recordRead(index, found);
    return found;
  }

  /// The place of a value that need not be computed, or null.
  const double* readable(int index) const {
    const Expression& expression = model_.expressions[at(index)];
    switch (expression.operation) {
      case Operator::constant:
      case Operator::element:
        return place(index);
      case Operator::parameter:
        return place(layout_.optionParameters[at(expression.a)] + expression.b);
      case Operator::variable:
        return place(layout_.variables + expression.a);
      case Operator::input: {
        const Variable& variable = bindings_.symbols[at(expression.a)].function.variable;
        return variable.kind == Variable::Kind::number
                   ? static_cast<const double*>(variable.address)
                   : nullptr;
      }
      default:
        return nullptr;
    }
  }

  /// The left operand is read first: a variable may be another after a call in the right one.
  std::pair<const double*, const double*> operands(const Expression& expression) {
    const double* left = value(expression.a);
    if (model_.expressions[at(expression.a)].operation == Operator::input &&
        left != place(expression.a) && !readable(expression.b)) {
      emit(Operation::copy, expression.a, left);
      left = place(expression.a);
    }
    return {left, value(expression.b)};
  }

  /// Computes a value into any place.
  void compute(int index, int to) {
    const Expression& expression = model_.expressions[at(index)];
    switch (expression.operation) {
      case Operator::input:
        if (readable(index)) break;
        return input(index, to);
      case Operator::stateTime:
        return read(Operation::stateTime, index, to);
      case Operator::optionTime:
        return read(Operation::optionTime, index, to);
      case Operator::actionDone:
        return read(Operation::actionDone, index, to);
      case Operator::conflict:
        return read(Operation::conflict, index, to);
      case Operator::negate:
        emit(Operation::negate, to, value(expression.a));
        return;
      case Operator::add:
        return arithmetic(Operation::add, expression, to);
      case Operator::subtract:
        return arithmetic(Operation::subtract, expression, to);
      case Operator::multiply:
        return arithmetic(Operation::multiply, expression, to);
      case Operator::divide:
      case Operator::modulo:
        arithmetic(expression.operation == Operator::divide ? Operation::divide : Operation::modulo,
                   expression, index);
        if (to != index) emit(Operation::copy, to, place(index));
        return;
      case Operator::conditional:
        return choose(expression, to);
      case Operator::constant:
      case Operator::element:
      case Operator::parameter:
      case Operator::variable:
        break;
      default:
        return truth(index, to);
    }
    emit(Operation::copy, to, value(index));
  }

  void arithmetic(Operation operation, const Expression& expression, int to) {
    const auto [left, right] = operands(expression);
    emit(operation, to, left).b = right;
  }

  void choose(const Expression& expression, int to) {
    Label otherwise, end;
    jumpIf(false, expression.a, otherwise);
    compute(expression.b, to);
    jump(Operation::jump, end);
    bind(otherwise);
    compute(expression.c, to);
    bind(end);
  }

  void truth(int condition, int to) {
    Label otherwise, end;
    jumpIf(false, condition, otherwise);
    emit(Operation::one, to);
    jump(Operation::jump, end);
    bind(otherwise);
    emit(Operation::zero, to);
    bind(end);
  }

  void read(Operation operation, int index, int to) {
    emit(operation, to);
    recordRead(index, place(to));
  }

  /// An input that is no variable of type double.
  void input(int index, int to) {
    const Expression& expression = model_.expressions[at(index)];
    const Bindings::Bound& bound = bindings_.symbols[at(expression.a)];
    switch (bound.function.variable.kind) {
      case Variable::Kind::single:
        emit(Operation::readSingle, to).variable = bound.function.variable.address;
        break;
      case Variable::Kind::boolean:
        emit(Operation::readBoolean, to).variable = bound.function.variable.address;
        break;
      case Variable::Kind::byte:
        emit(Operation::readByte, to).variable = bound.function.variable.address;
        break;
      case Variable::Kind::integer:
        emit(Operation::readInteger, to).variable = bound.function.variable.address;
        break;
      default:
        call(expression, bound, layout_.arguments[at(index)], to);
    }
    recordRead(index, place(to));
  }

  /// Each call has places of its own for its arguments, so that calls may stand inside one another.
  void call(const Expression& expression, const Bindings::Bound& bound, int arguments, int to) {
    for (std::size_t p = 0; p < bound.order.size(); ++p)
      compute(model_.operands[at(expression.b) + p], arguments + bound.order[p]);
    if (recorded_)
      for (std::size_t p = 0; p < bound.order.size(); ++p)
        emit(Operation::recordArgument, 0, place(arguments + bound.order[p])).index =
            static_cast<int>(p);
    emit(Operation::call, to, place(arguments)).function = &bound.function;
  }

  // Actions

  void actions(Span span) {
    for (const Action& action : span.of(model_.actions)) {
      if (action.kind == Action::Kind::assignment)
        assign(action);
      else if (action.kind == Action::Kind::option)
        callOption(action);
      else
        callBehavior(action);
    }
  }

  void assign(const Action& action) {
    const int variable = layout_.variables + action.target;
    compute(action.operand, variable);
    emit(Operation::set).index = action.target;
    if (recorded_) emit(Operation::recordAssignment, 0, place(variable)).index = action.target;
  }

  void callOption(const Action& action) {
    const int first = layout_.optionParameters[at(action.target)];
    const std::size_t count = model_.options[at(action.target)].parameters.size();
    for (std::size_t p = 0; p < count; ++p)
      compute(model_.operands[at(action.operand) + p], first + static_cast<int>(p));
    emit(Operation::callOption).index = action.target;
  }

  void callBehavior(const Action& action) {
    const Bindings::Bound& behavior = bindings_.behaviors[at(action.target)];
    const int first = layout_.behaviorParameters[at(action.target)];
    const bool notifies = behavior.parametersChanged != nullptr && !behavior.order.empty();
    for (std::size_t p = 0; p < behavior.order.size(); ++p) {
      const int operand = model_.operands[at(action.operand) + p];
      if (notifies)
        emit(Operation::pass, first + behavior.order[p], value(operand));
      else
        compute(operand, first + behavior.order[p]);
    }
    if (notifies) emit(Operation::notifyOfChanges).index = action.target;
    if (recorded_) emit(Operation::recordBehavior).index = action.target;
    emit(Operation::callBehavior).index = action.target;
    keepParameters(first, behavior.order.size());
  }

  // Instructions

  int next() const { return static_cast<int>(program_.code.size()); }

  Instruction& emit(Operation operation, int to = 0, const double* a = nullptr) {
    return program_.code.emplace_back(Instruction{operation, to, a, {}});
  }

  void jump(Operation operation, Label& label, const double* a = nullptr,
            const double* b = nullptr) {
    label.jumps.push_back(next());
    emit(operation, 0, a).b = b;
  }

  /// What is written next is what the label stands for.
  void bind(const Label& label) {
    for (const int jump : label.jumps) program_.code[at(jump)].to = next();
  }

  void recordRead(int index, const double* place) {
    if (recorded_) emit(Operation::recordRead, 0, place).index = index;
  }

  const Model& model_;
  const Bindings& bindings_;
  const MemoryLayout& layout_;
  const double* memory_;
  bool recorded_;
  Program program_;
};

}  // namespace

MemoryLayout::MemoryLayout(const Model& model) : arguments(model.expressions.size()) {
  int next = static_cast<int>(model.expressions.size());
  const auto reserve = [&](std::size_t count) {
    return std::exchange(next, next + static_cast<int>(count));
  };
  for (const Option& option : model.options)
    optionParameters.push_back(reserve(option.parameters.size()));
  for (const BasicBehavior& behavior : model.behaviors)
    behaviorParameters.push_back(reserve(behavior.parameters.size()));
  for (std::size_t i = 0; i < model.expressions.size(); ++i)
    if (model.expressions[i].operation == Operator::input)
      arguments[i] = reserve(model.symbols[at(model.expressions[i].a)].parameters.size());
  variables = reserve(model.symbols.size());
  size = at(next);
}

Program makeProgram(const Model& model, const Bindings& bindings, const MemoryLayout& layout,
                    const double* memory, bool recorded) {
  return ProgramWriter(model, bindings, layout, memory, recorded).run();
}

}  // namespace xabsl
