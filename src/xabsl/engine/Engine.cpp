#include "xabsl/engine/Engine.h"

#include <cmath>
#include <cstring>
#include <utility>

namespace xabsl {

namespace {

constexpr std::size_t mostWarnings = 100;

template <typename T>
double numberAt(const void* variable) {
  T value;
  std::memcpy(&value, variable, sizeof(value));
  return static_cast<double>(value);
}

}  // namespace

Engine::Creation Engine::create(const Behavior& behavior, const Symbols& symbols) {
  Creation creation;
  Bindings bindings = link(behavior.model(), symbols, creation.diagnostics);
  if (!fails(creation.diagnostics)) creation.engine = Engine(behavior, std::move(bindings));
  return creation;
}

Engine::Engine(const Behavior& behavior, Bindings bindings)
    : model_(behavior.shared()),
      bindings_(std::move(bindings)),
      layout_(*model_),
      memory_(layout_.size),
      cooperation_(*model_) {
  cooperates_ = !cooperation_.message().marks.empty();
  root_ = model_->agents[agent_].rootOption;
  if (model_->dialect == Dialect::xabsl21) pending_.resize(model_->symbols.size());
  prepareMemory();
  program_ = makeProgram(*model_, bindings_, layout_, memory_.data(), false);
  frames_.resize(model_->options.size() + 1);  // options do not call one another in a circle
  options_.resize(model_->options.size());
  for (std::size_t i = 0; i < options_.size(); ++i) options_[i].option = static_cast<int>(i);
  behaviorCycles_.resize(model_->behaviors.size());
  executed_.reserve(model_->largestActivation);
  executedValues_.reserve(model_->largestActivation);
  warnings_.reserve(mostWarnings);
  warnedExpressions_.resize(model_->expressions.size());
  warnedOptions_.resize(options_.size());
  warnedBehaviors_.resize(model_->behaviors.size());
}

/// Initializes constants, and the first values of parameters and symbols.
void Engine::prepareMemory() {
  for (std::size_t i = 0; i < model_->expressions.size(); ++i) {
    const Expression& expression = model_->expressions[i];
    memory_[i] = expression.operation == Operator::element
                     ? bindings_.elements[at(expression.a)][at(expression.b)]
                     : expression.number;
  }
  // The first expressions are what stands for parameters that are not given.
  for (int i = 0; i < static_cast<int>(bindings_.firstElements.size()); ++i)
    memory_[at(Model::defaultExpression({ValueKind::enumeration, i}))] =
        bindings_.firstElements[at(i)];
  for (std::size_t i = 0; i < model_->options.size(); ++i)
    for (std::size_t p = 0; p < model_->options[i].parameters.size(); ++p)
      memory_[at(layout_.optionParameters[i]) + p] =
          firstValue(model_->options[i].parameters[p].type);
  for (std::size_t i = 0; i < model_->behaviors.size(); ++i)
    for (std::size_t p = 0; p < model_->behaviors[i].parameters.size(); ++p)
      memory_[at(layout_.behaviorParameters[i] + bindings_.behaviors[i].order[p])] =
          firstValue(model_->behaviors[i].parameters[p].type);
  for (std::size_t i = 0; i < model_->symbols.size(); ++i)
    variable(i) = firstValue(model_->symbols[i].type);
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
  if (recorder_) recorder_->add(TraceEvent::Kind::cycle, 0, static_cast<double>(now_));
  if (rootKind_ == Activation::Kind::option)
    run(recorder_ ? recordedProgram_ : program_);
  else
    runBehavior(root_);
  for (std::size_t i = 0; i < pending_.size(); ++i)
    if (std::exchange(pending_[i], 0)) apply(i);
}

/// Executes a single basic behavior (report H.8).
void Engine::runBehavior(int index) {
  if (recorder_) recordBehavior(index, 0);
  callBehavior(index, 0);
  const std::size_t count = model_->behaviors[at(index)].parameters.size();
  keepParameters(memory_.data() + layout_.behaviorParameters[at(index)], count);
}

/// Executes a program from the root option until that returns. Decisions and calls are handled
/// here, in one switch, so that a condition costs only its comparison and a jump. All other
/// operations are in valueOf(), act() and recordEvent(). Operations that compute a value come
/// first, up to `conflict`.
void Engine::run(const Program& program) {
  const Instruction* const code = program.code.data();
  const Program::StateCode* const states = program.states.data();
  Frame* frame = frames_.data();
  *frame = {nullptr, nullptr};
  OptionState* option = &options_[at(root_)];
  enter(*option);
  const Instruction* next = code + states[option->state].decide;
  for (;;) {
    const Instruction& i = *next++;
    const auto depth = static_cast<int>(frame - frames_.data());
    switch (i.operation) {
      case Operation::call:
        memory_[at(i.to)] = i.function->call(i.function->object.get(), i.a);
        break;
      case Operation::jump:
        next = code + i.to;
        break;
      case Operation::ifTrue:
        if (*i.a != 0) next = code + i.to;
        break;
      case Operation::ifFalse:
        if (*i.a == 0) next = code + i.to;
        break;
      case Operation::ifLess:
        if (*i.a < *i.b) next = code + i.to;
        break;
      case Operation::ifNotLess:
        if (!(*i.a < *i.b)) next = code + i.to;
        break;
      case Operation::ifLessEqual:
        if (*i.a <= *i.b) next = code + i.to;
        break;
      case Operation::ifNotLessEqual:
        if (!(*i.a <= *i.b)) next = code + i.to;
        break;
      case Operation::ifEqual:
        if (*i.a == *i.b) next = code + i.to;
        break;
      case Operation::ifNotEqual:
        if (*i.a != *i.b) next = code + i.to;
        break;
      case Operation::decideInState:
        next = code + states[option->state].decideInState;
        break;
      case Operation::actInState:
        next = code + states[option->state].actInState;
        break;
      case Operation::changeIfAgreed:
        if (i.index != option->state && cooperation_.mayEnter(i.index)) change(*option, i.index);
        note(*option, depth);
        next = code + states[option->state].act;
        break;
      case Operation::change:
        if (i.index != option->state) change(*option, i.index);
        [[fallthrough]];
      case Operation::stay:
        note(*option, depth);
        next = code + i.to;
        break;
      case Operation::callBehavior:
        callBehavior(i.index, depth + 1);
        break;
      case Operation::callOption:
        *++frame = {next, option};
        option = &options_[at(i.index)];
        enter(*option);
        next = code + states[option->state].decide;
        break;
      case Operation::back:
        if (depth == 0) return;
        next = frame->next;
        option = frame->caller;
        --frame;
        break;
      default:
        if (i.operation <= Operation::conflict)
          memory_[at(i.to)] = valueOf(i, *option);
        else
          act(i, *option, depth);
    }
  }
}

void Engine::act(const Instruction& i, const OptionState& option, int depth) {
  switch (i.operation) {
    case Operation::keepParameters:
      return keepParameters(i.a, at(i.index));
    case Operation::markOption:
      return cooperation_.markOption(i.index, option.state);
    case Operation::set:
      return set(at(i.index));
    case Operation::pass:
      parametersChanged_ |= std::exchange(memory_[at(i.to)], *i.a) != *i.a;
      return;
    case Operation::notifyOfChanges:
      if (std::exchange(parametersChanged_, false)) notifyOfChanges(at(i.index));
      return;
    default:
      recordEvent(i, option, depth);
  }
}

double Engine::valueOf(const Instruction& i, const OptionState& option) {
  switch (i.operation) {
    case Operation::copy:
      return *i.a;
    case Operation::one:
      return 1;
    case Operation::negate:
      return 0 - *i.a;  // as in intermediate code, where 0 has no sign
    case Operation::add:
      return *i.a + *i.b;
    case Operation::subtract:
      return *i.a - *i.b;
    case Operation::multiply:
      return *i.a * *i.b;
    case Operation::divide:
      return divide(i);
    case Operation::modulo:
      return modulo(i);
    case Operation::readSingle:
      return numberAt<float>(i.variable);
    case Operation::readBoolean:
      return numberAt<bool>(i.variable);
    case Operation::readByte:
      return numberAt<std::uint8_t>(i.variable);
    case Operation::readInteger:
      return numberAt<std::int32_t>(i.variable);
    case Operation::stateTime:
      return static_cast<double>(since(option.stateActivation, now_));
    case Operation::optionTime:
      return static_cast<double>(since(option.activation, now_));
    case Operation::actionDone:
      return actionDone(option);
    case Operation::conflict:
      return cooperation_.conflict(option.state);
    default:
      return 0;  // Operation::zero
  }
}

/// The difference of two times; wraps around if a clock is broken.
std::int64_t Engine::since(std::int64_t then, std::int64_t now) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(now) -
                                   static_cast<std::uint64_t>(then));
}

bool Engine::wasActive(const OptionState& option) const {
  return (option.cycle == cycle_ ? option.previous : option.cycle) + 1 == cycle_;
}

/// Marks an option as active in this cycle.
inline void Engine::enter(OptionState& option) {
  if (option.cycle + 1 != cycle_) return enterAnew(option);
  option.previous = option.cycle;
  option.cycle = cycle_;
}

/// Starts an option that was not active in the cycle before in its initial state.
void Engine::enterAnew(OptionState& option) {
  const Option& declared = model_->options[at(option.option)];
  if (!wasActive(option)) {
    option.activation = now_;
    option.stateActivation = now_;
    option.state = declared.initialState;
  }
  if (option.cycle == cycle_)
    return warnOnce(warnedOptions_[at(option.option)],
                    "option is executed more than once in a cycle", declared.location);
  option.previous = option.cycle;
  option.cycle = cycle_;
}

void Engine::change(OptionState& option, int state) {
  if (recorder_) recorder_->add(TraceEvent::Kind::change, option.state, state);
  option.state = state;
  option.stateActivation = now_;
}

inline void Engine::note(const OptionState& option, int depth) {
  executed_.push_back({option.option, option.state, depth, option.stateActivation});
}

void Engine::keepParameters(const double* first, std::size_t count) {
  executedValues_.insert(executedValues_.end(), first, first + count);
}

void Engine::notifyOfChanges(std::size_t behavior) const {
  const auto& changed = bindings_.behaviors[behavior].parametersChanged;
  if (changed) changed(memory_.data() + layout_.behaviorParameters[behavior]);
}

void Engine::callBehavior(int index, int depth) {
  const Function& function = bindings_.behaviors[at(index)].function;
  if (std::exchange(behaviorCycles_[at(index)], cycle_) == cycle_)
    warnOnce(warnedBehaviors_[at(index)], "basic behavior is executed more than once in a cycle",
             model_->behaviors[at(index)].location);
  executed_.push_back({index, -1, depth, 0});
  function.call(function.object.get(), memory_.data() + layout_.behaviorParameters[at(index)]);
}

/// XABSL 2.1 sets outputs after the whole graph was executed (report H.7), later versions at once.
void Engine::set(std::size_t symbol) {
  if (pending_.empty())
    apply(symbol);
  else
    pending_[symbol] = 1;
}

void Engine::apply(std::size_t symbol) {
  const Function& function = bindings_.symbols[symbol].function;
  if (function.call) function.call(function.object.get(), &variable(symbol));
}

bool Engine::actionDone(const OptionState& option) const {
  return subOptionDone(model_->options[at(option.option)].commonActions) ||
         subOptionDone(model_->states[at(option.state)].actions);
}

bool Engine::subOptionDone(Span actions) const {
  for (const Action& action : actions.of(model_->actions)) {
    if (action.kind != Action::Kind::option) continue;
    const OptionState& called = options_[at(action.target)];
    if (wasActive(called) && model_->states[at(called.state)].target) return true;
  }
  return false;
}

/// Division by zero divides by a very small number instead, as XABSL engines do.
double Engine::divide(const Instruction& instruction) {
  constexpr double almostZero = 1e-7;
  if (*instruction.b != 0) return *instruction.a / *instruction.b;
  warnOnce(warnedExpressions_[at(instruction.to)], "division by zero",
           model_->expressionLocations[at(instruction.to)]);
  return *instruction.a / almostZero;
}

/// The remainder of the whole parts, and 0 for a division by zero. A remainder of 0 has no sign, as
/// for whole numbers.
double Engine::modulo(const Instruction& instruction) {
  const double divisor = std::trunc(*instruction.b);
  if (divisor != 0) return std::fmod(std::trunc(*instruction.a), divisor) + 0.0;
  warnOnce(warnedExpressions_[at(instruction.to)], "remainder of a division by zero",
           model_->expressionLocations[at(instruction.to)]);
  return 0;
}

void Engine::warnOnce(char& warned, const char* text, Location location) {
  if (warned || warnings_.size() == warnings_.capacity()) return;
  warned = 1;
  warnings_.push_back({text, location});
}

}  // namespace xabsl
