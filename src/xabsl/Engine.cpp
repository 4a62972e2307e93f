#include "xabsl/Engine.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

namespace xabsl {

namespace {

constexpr std::size_t mostWarnings = 100;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// The difference of two times; wraps round where a clock is broken.
std::int64_t since(std::int64_t then, std::int64_t now) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(now) -
                                   static_cast<std::uint64_t>(then));
}

}  // namespace

Engine::Creation Engine::create(const Behavior& behavior, const Symbols& symbols) {
  Creation creation;
  Bindings bindings = link(behavior.model(), symbols, creation.diagnostics);
  if (!hasErrors(creation.diagnostics)) creation.engine = Engine(behavior, std::move(bindings));
  return creation;
}

Engine::Engine(const Behavior& behavior, Bindings bindings)
    : model_(behavior.shared()),
      bindings_(std::move(bindings)),
      expressions_(model_->expressions),
      cooperation_(*model_) {
  cooperates_ = !cooperation_.message().marks.empty();
  root_ = model_->agents[agent_].rootOption;
  if (model_->dialect == Dialect::xabsl21) pending_.resize(model_->symbols.size());
  prepareSymbols();
  prepareParameters();
  prepareExpressions();
  options_.resize(model_->options.size());
  for (std::size_t i = 0; i < options_.size(); ++i) options_[i].option = static_cast<int>(i);
  behaviorCycles_.resize(model_->behaviors.size());
  executed_.reserve(model_->largestActivation);
  executedValues_.reserve(model_->largestActivation);
  warnings_.reserve(mostWarnings);
  warnedExpressions_.resize(expressions_.size());
  warnedOptions_.resize(options_.size());
  warnedBehaviors_.resize(model_->behaviors.size());
}

void Engine::prepareSymbols() {
  for (std::size_t i = 0; i < model_->symbols.size(); ++i) {
    const Function& function = bindings_.symbols[i].function;
    ports_.push_back({function.call, function.object.get()});
    variables_.push_back(firstValue(model_->symbols[i].type));
  }
}

void Engine::prepareParameters() {
  for (const Option& option : model_->options) {
    optionSlots_.push_back(slots_.size());
    for (const Parameter& parameter : option.parameters)
      slots_.push_back(firstValue(parameter.type));
  }
  for (std::size_t i = 0; i < model_->behaviors.size(); ++i) {
    behaviorSlots_.push_back(slots_.size());
    const std::vector<Parameter>& parameters = model_->behaviors[i].parameters;
    slots_.resize(slots_.size() + parameters.size());
    for (std::size_t p = 0; p < parameters.size(); ++p)
      slots_[behaviorSlots_[i] + at(bindings_.behaviors[i].order[p])] =
          firstValue(parameters[p].type);
  }
}

/// Puts this engine's values and slots into the expressions, so that a cycle need not look for
/// them.
void Engine::prepareExpressions() {
  // The first expressions are what stands for parameters that are not given.
  for (std::size_t i = 0; i < bindings_.firstElements.size(); ++i) {
    const auto index = at(Model::defaultExpression({ValueKind::enumeration, static_cast<int>(i)}));
    expressions_[index].operation = Operator::constant;
    expressions_[index].number = bindings_.firstElements[i];
  }
  for (Expression& expression : expressions_) {
    if (expression.operation == Operator::element) {
      expression.number = bindings_.elements[at(expression.a)][at(expression.b)];
      expression.operation = Operator::constant;
    } else if (expression.operation == Operator::parameter) {
      expression.a = static_cast<int>(optionSlots_[at(expression.a)]) + expression.b;
    } else if (expression.operation == Operator::input) {
      const std::size_t count = model_->symbols[at(expression.a)].parameters.size();
      if (count == 0) continue;
      // Each call has slots of its own, so that calls may stand inside one another.
      expression.c = static_cast<int>(slots_.size());
      slots_.resize(slots_.size() + count);
    }
  }
}

double Engine::firstValue(Type type) const {
  return type.kind == ValueKind::enumeration ? bindings_.firstElements[at(type.enumeration)] : 0;
}

void Engine::execute(std::int64_t now) {
  ++cycle_;
  now_ = now;
  executed_.clear();
  executedValues_.clear();
  if (cooperates_) cooperation_.beginCycle();
  if (recorder_)
    executeRoot<true>();
  else
    executeRoot<false>();
  for (std::size_t i = 0; i < pending_.size(); ++i)
    if (std::exchange(pending_[i], 0)) apply(i);
}

template <bool recorded>
void Engine::executeRoot() {
  if constexpr (recorded) recorder_->add(TraceEvent::Kind::cycle, 0, static_cast<double>(now_));
  if (rootKind_ == Activation::Kind::option)
    executeOption<recorded>(root_, 0);
  else
    executeBehavior<recorded>(root_, 0);
}

/// XABSL 2.1 sets outputs after the whole graph (report H.7), its successors at once.
inline void Engine::assign(std::size_t symbol, double value) {
  variables_[symbol] = value;
  if (pending_.empty())
    apply(symbol);
  else
    pending_[symbol] = 1;
}

void Engine::apply(std::size_t symbol) {
  const Port& port = ports_[symbol];
  if (port.call) port.call(port.object, &variables_[symbol]);
}

bool Engine::wasActive(const OptionState& option) const {
  return (option.cycle == cycle_ ? option.previous : option.cycle) + 1 == cycle_;
}

/// Notes that an option is active now, and starts it afresh if it was not in the cycle before.
void Engine::enter(OptionState& option) {
  const Option& declared = model_->options[at(option.option)];
  if (!wasActive(option)) {
    option.activation = now_;
    option.stateActivation = now_;
    option.state = declared.initialState;
  }
  if (option.cycle == cycle_) {
    warnOnce(warnedOptions_[at(option.option)], "option is executed more than once in a cycle",
             declared.location);
  } else {
    option.previous = option.cycle;
    option.cycle = cycle_;
  }
  option.optionTime = since(option.activation, now_);
  option.stateTime = since(option.stateActivation, now_);
}

template <bool recorded>
void Engine::executeOption(int index, int depth) {
  OptionState& option = options_[at(index)];
  const Option& declared = model_->options[at(index)];
  enter(option);
  if constexpr (recorded) recorder_->add(TraceEvent::Kind::option, index, depth);
  decide<recorded>(option);
  if (cooperates_) cooperation_.markOption(index, option.state);
  note({Activation::Kind::option, index, depth, option.state, option.optionTime, option.stateTime},
       optionSlots_[at(index)], declared.parameters.size());
  if constexpr (recorded) recordOption(option);
  const Span actions = model_->states[at(option.state)].actions;
  executeActions<recorded>(declared.commonActions, option, depth);
  executeActions<recorded>(actions, option, depth);
}

/// The common decision tree comes first; the state's own is asked where that one decided nothing
/// (report F.5).
template <bool recorded>
void Engine::decide(OptionState& option) {
  Branch end = follow<recorded>(model_->options[at(option.option)].commonDecision, option);
  if (end.kind == Branch::Kind::none)
    end = follow<recorded>(model_->states[at(option.state)].decision, option);
  if (end.kind != Branch::Kind::state || end.index == option.state) return;
  if (cooperates_ && !cooperation_.mayEnter(end.index)) return;
  if constexpr (recorded) recorder_->add(TraceEvent::Kind::change, option.state, end.index);
  option.state = end.index;
  option.stateActivation = now_;
  option.stateTime = 0;
}

template <bool recorded>
Branch Engine::follow(Branch branch, const OptionState& option) {
  while (branch.kind == Branch::Kind::decision) {
    const Decision& decision = model_->decisions[at(branch.index)];
    const bool holds = evaluate<recorded>(decision.condition, option) != 0;
    if constexpr (recorded) recorder_->add(TraceEvent::Kind::decide, branch.index, holds);
    branch = holds ? decision.then : decision.otherwise;
  }
  return branch;
}

template <bool recorded>
void Engine::executeActions(Span span, const OptionState& caller, int depth) {
  for (int i = span.first; i < span.first + span.count; ++i) {
    const Action& action = model_->actions[at(i)];
    const int* operands = model_->operands.data() + action.operand;
    if (action.kind == Action::Kind::assignment) {
      assign(at(action.target), operand<recorded>(action.operand, caller));
      if constexpr (recorded)
        recorder_->add(TraceEvent::Kind::assign, action.target, variables_[at(action.target)]);
    } else if (action.kind == Action::Kind::option) {
      double* slot = slots_.data() + optionSlots_[at(action.target)];
      const std::size_t count = model_->options[at(action.target)].parameters.size();
      for (std::size_t p = 0; p < count; ++p) slot[p] = operand<recorded>(operands[p], caller);
      executeOption<recorded>(action.target, depth + 1);
    } else {
      const Bindings::Bound& behavior = bindings_.behaviors[at(action.target)];
      double* slot = slots_.data() + behaviorSlots_[at(action.target)];
      bool changed = false;
      for (std::size_t p = 0; p < behavior.order.size(); ++p) {
        double& parameter = slot[behavior.order[p]];
        const double before = std::exchange(parameter, operand<recorded>(operands[p], caller));
        changed = changed || before != parameter;
      }
      if (changed && behavior.parametersChanged) behavior.parametersChanged();
      executeBehavior<recorded>(action.target, depth + 1);
    }
  }
}

template <bool recorded>
void Engine::executeBehavior(int index, int depth) {
  const std::size_t firstSlot = behaviorSlots_[at(index)];
  const Function& function = bindings_.behaviors[at(index)].function;
  if (behaviorCycles_[at(index)] == cycle_)
    warnOnce(warnedBehaviors_[at(index)], "basic behavior is executed more than once in a cycle",
             model_->behaviors[at(index)].location);
  behaviorCycles_[at(index)] = cycle_;
  note({Activation::Kind::behavior, index, depth, -1, 0, 0}, firstSlot,
       model_->behaviors[at(index)].parameters.size());
  if constexpr (recorded) recordBehavior(index, depth);
  function.call(function.object.get(), slots_.data() + firstSlot);
}

void Engine::recordOption(const OptionState& option) {
  const std::size_t count = model_->options[at(option.option)].parameters.size();
  recorder_->add(TraceEvent::Kind::state, option.state, static_cast<double>(option.stateTime));
  recorder_->add(TraceEvent::Kind::optionTime, option.option,
                 static_cast<double>(option.optionTime));
  for (std::size_t p = 0; p < count; ++p)
    recorder_->add(TraceEvent::Kind::parameter, static_cast<int>(p),
                   slots_[optionSlots_[at(option.option)] + p]);
}

void Engine::recordBehavior(int index, int depth) {
  recorder_->add(TraceEvent::Kind::behavior, index, depth);
  const std::vector<int>& order = bindings_.behaviors[at(index)].order;
  for (std::size_t p = 0; p < order.size(); ++p)
    recorder_->add(TraceEvent::Kind::parameter, static_cast<int>(p),
                   slots_[behaviorSlots_[at(index)] + at(order[p])]);
}

void Engine::note(const Executed& executed, std::size_t firstSlot, std::size_t count) {
  executed_.push_back(executed);
  for (std::size_t i = firstSlot; i < firstSlot + count; ++i) executedValues_.push_back(slots_[i]);
}

void Engine::warnOnce(char& warned, const char* text, Location location) {
  if (warned || warnings_.size() == warnings_.capacity()) return;
  warned = 1;
  warnings_.push_back({text, location});
}

/// A value that was not computed from others.
template <bool recorded>
inline double Engine::read(int index, double value) {
  if constexpr (recorded) recorder_->add(TraceEvent::Kind::read, index, value);
  return value;
}

/// Leaves are most of what conditions consist of: they are not worth a call.
template <bool recorded>
inline double Engine::operand(int index, const OptionState& option) {
  const Expression& expression = expressions_[at(index)];
  if (expression.operation == Operator::constant) return expression.number;
  if (expression.operation == Operator::input) return input<recorded>(index, option);
  return evaluate<recorded>(index, option);
}

template <bool recorded>
inline double Engine::input(int index, const OptionState& option) {
  const Expression& expression = expressions_[at(index)];
  const Port& port = ports_[at(expression.a)];
  if (expression.c < 0) return read<recorded>(index, port.call(port.object, nullptr));
  const std::vector<int>& order = bindings_.symbols[at(expression.a)].order;
  double* slots = slots_.data() + expression.c;
  for (std::size_t p = 0; p < order.size(); ++p)
    slots[order[p]] = operand<recorded>(model_->operands[at(expression.b) + p], option);
  if constexpr (recorded)
    for (std::size_t p = 0; p < order.size(); ++p)
      recorder_->add(TraceEvent::Kind::argument, static_cast<int>(p), slots[order[p]]);
  return read<recorded>(index, port.call(port.object, slots));
}

template <bool recorded>
double Engine::evaluate(int index, const OptionState& option) {
  const Expression& expression = expressions_[at(index)];
  // The left operand is read first, whatever the compiler would prefer.
  const auto apply = [&](auto operation) -> double {
    const double left = operand<recorded>(expression.a, option);
    const double right = operand<recorded>(expression.b, option);
    return operation(left, right);
  };
  const auto anyIs = [&](bool wanted) {
    for (int i = expression.b; i < expression.b + expression.c; ++i)
      if ((operand<recorded>(model_->operands[at(i)], option) != 0) == wanted) return true;
    return false;
  };
  switch (expression.operation) {
    case Operator::constant:
    case Operator::element:
      return expression.number;
    case Operator::parameter:
      return read<recorded>(index, slots_[at(expression.a)]);
    case Operator::input:
      return input<recorded>(index, option);
    case Operator::variable:
      return read<recorded>(index, variables_[at(expression.a)]);
    case Operator::stateTime:
      return read<recorded>(index, static_cast<double>(option.stateTime));
    case Operator::optionTime:
      return read<recorded>(index, static_cast<double>(option.optionTime));
    case Operator::actionDone:
      return read<recorded>(index, actionDone(option));
    case Operator::conflict:
      return read<recorded>(index, cooperation_.conflict(option.state));
    case Operator::negate:
      return -operand<recorded>(expression.a, option);
    case Operator::logicalNot:
      return operand<recorded>(expression.a, option) == 0;
    case Operator::divide:
      return divide<recorded>(index, option);
    case Operator::modulo:
      return modulo<recorded>(index, option);
    case Operator::logicalAnd:
      return !anyIs(false);
    case Operator::logicalOr:
      return anyIs(true);
    case Operator::conditional:
      return operand<recorded>(
          operand<recorded>(expression.a, option) != 0 ? expression.b : expression.c, option);
    case Operator::add:
      return apply(std::plus<>());
    case Operator::subtract:
      return apply(std::minus<>());
    case Operator::multiply:
      return apply(std::multiplies<>());
    case Operator::equal:
      return apply(std::equal_to<>());
    case Operator::notEqual:
      return apply(std::not_equal_to<>());
    case Operator::less:
      return apply(std::less<>());
    case Operator::lessEqual:
      return apply(std::less_equal<>());
    case Operator::greater:
      return apply(std::greater<>());
    case Operator::greaterEqual:
      return apply(std::greater_equal<>());
  }
  return 0;
}

/// Division by zero divides by a very small number instead, as XABSL engines do.
template <bool recorded>
double Engine::divide(int index, const OptionState& option) {
  constexpr double almostZero = 1e-7;
  const Expression& expression = expressions_[at(index)];
  const double dividend = operand<recorded>(expression.a, option);
  const double divisor = operand<recorded>(expression.b, option);
  if (divisor != 0) return dividend / divisor;
  warnOnce(warnedExpressions_[at(index)], "division by zero",
           model_->expressionLocations[at(index)]);
  return dividend / almostZero;
}

/// The remainder of the whole parts; of a division by zero it is 0.
template <bool recorded>
double Engine::modulo(int index, const OptionState& option) {
  const Expression& expression = expressions_[at(index)];
  const double dividend = std::trunc(operand<recorded>(expression.a, option));
  const double divisor = std::trunc(operand<recorded>(expression.b, option));
  if (divisor != 0) return std::fmod(dividend, divisor);
  warnOnce(warnedExpressions_[at(index)], "remainder of a division by zero",
           model_->expressionLocations[at(index)]);
  return 0;
}

bool Engine::actionDone(const OptionState& option) const {
  return subOptionDone(model_->options[at(option.option)].commonActions) ||
         subOptionDone(model_->states[at(option.state)].actions);
}

bool Engine::subOptionDone(Span actions) const {
  for (int i = actions.first; i < actions.first + actions.count; ++i) {
    const Action& action = model_->actions[at(i)];
    if (action.kind != Action::Kind::option) continue;
    const OptionState& called = options_[at(action.target)];
    if (wasActive(called) && model_->states[at(called.state)].target) return true;
  }
  return false;
}

const std::string& Engine::selectedAgent() const {
  return model_->agents[agent_].name;
}

std::vector<Activation> Engine::activations() const {
  std::vector<Activation> activations;
  std::size_t value = 0;
  for (const Executed& executed : executed_) {
    const bool isOption = executed.kind == Activation::Kind::option;
    const std::string& name = isOption ? model_->options[at(executed.index)].name
                                       : model_->behaviors[at(executed.index)].name;
    Activation activation{executed.kind,       executed.depth,     name, {}, false,
                          executed.optionTime, executed.stateTime, {}};
    if (isOption) {
      const State& state = model_->states[at(executed.state)];
      activation.state = state.name;
      activation.target = state.target;
      for (const Parameter& parameter : model_->options[at(executed.index)].parameters)
        activation.parameters.push_back(
            named(parameter.name, parameter.type, executedValues_[value++]));
    } else {
      // The values stand in the order of the C++ function's arguments.
      const std::vector<Parameter>& parameters = model_->behaviors[at(executed.index)].parameters;
      const std::vector<int>& order = bindings_.behaviors[at(executed.index)].order;
      for (std::size_t p = 0; p < parameters.size(); ++p)
        activation.parameters.push_back(
            named(parameters[p].name, parameters[p].type, executedValues_[value + at(order[p])]));
      value += parameters.size();
    }
    activations.push_back(std::move(activation));
  }
  return activations;
}

std::optional<NamedValue> Engine::symbol(std::string_view name) const {
  for (std::size_t i = 0; i < model_->symbols.size(); ++i) {
    const Symbol& symbol = model_->symbols[i];
    if (symbol.name != name) continue;
    if (symbol.kind != SymbolKind::input) return named(symbol.name, symbol.type, variables_[i]);
    if (!symbol.parameters.empty()) return std::nullopt;
    return named(symbol.name, symbol.type, ports_[i].call(ports_[i].object, nullptr));
  }
  return std::nullopt;
}

NamedValue Engine::named(const std::string& name, Type type, double number) const {
  NamedValue value{name, type.kind, number, {}};
  if (type.kind == ValueKind::boolean) {
    value.text = number != 0 ? "true" : "false";
    return value;
  }
  if (type.kind == ValueKind::enumeration) {
    const std::vector<double>& values = bindings_.elements[at(type.enumeration)];
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] == number)
        value.text = model_->enumerations[at(type.enumeration)].elements[i].name;
    if (!value.text.empty()) return value;
  }
  char buffer[32];
  value.text.assign(buffer, std::to_chars(buffer, buffer + sizeof(buffer), number).ptr);
  return value;
}

std::vector<Diagnostic> Engine::warnings() const {
  std::vector<Diagnostic> diagnostics;
  for (const Warning& warning : warnings_)
    diagnostics.push_back({Diagnostic::Severity::warning, model_->files[at(warning.location.file)],
                           warning.location.line, warning.location.column, warning.text});
  return diagnostics;
}

}  // namespace xabsl
