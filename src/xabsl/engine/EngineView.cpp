#include <utility>

#include "xabsl/engine/Engine.h"
#include "xabsl/language/ModelText.h"

/// The state of an engine for people and tools (report H.8), and the events for a recorder.
namespace xabsl {

const std::string& Engine::selectedAgent() const {
  return model_->agents[agent_].name;
}

const std::string& Engine::root() const {
  return rootKind_ == Activation::Kind::option ? model_->options[at(root_)].name
                                               : model_->behaviors[at(root_)].name;
}

std::vector<Activation> Engine::activations() const {
  std::vector<Activation> activations;
  std::size_t value = 0;
  for (const Executed& executed : executed_) {
    const bool isOption = executed.state >= 0;
    Activation activation;
    activation.kind = isOption ? Activation::Kind::option : Activation::Kind::behavior;
    activation.depth = executed.depth;
    activation.name = isOption ? model_->options[at(executed.index)].name
                               : model_->behaviors[at(executed.index)].name;
    if (isOption) {
      const State& state = model_->states[at(executed.state)];
      activation.state = state.name;
      activation.target = state.target;
      activation.optionTime = since(options_[at(executed.index)].activation, now_);
      activation.stateTime = since(executed.stateActivation, now_);
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
  const int output = model_->findOutput(name);
  const int index = output >= 0 ? output : model_->findInput(name);
  if (index < 0) return std::nullopt;
  const Symbol& symbol = model_->symbols[at(index)];
  if (output >= 0) return named(symbol.name, symbol.type, variable(at(index)));
  if (!symbol.parameters.empty()) return std::nullopt;
  return named(symbol.name, symbol.type, callInput(at(index), nullptr));
}

NamedValue Engine::named(const std::string& name, Type type, double number) const {
  return {name, type.kind, number, valueText(*model_, bindings_.elements, type, number)};
}

std::vector<Diagnostic> Engine::warnings() const {
  std::vector<Diagnostic> diagnostics;
  for (const Warning& warning : warnings_)
    diagnostics.push_back({Diagnostic::Severity::warning, model_->files[at(warning.location.file)],
                           warning.location.line, warning.location.column, warning.text});
  return diagnostics;
}

double Engine::callInput(std::size_t symbol, const double* arguments) const {
  const Function& function = bindings_.symbols[symbol].function;
  return function.call(function.object.get(), arguments);
}

// The events for a recorder

void Engine::record(TraceRecorder* recorder) {
  recorder_ = recorder;
  if (recorder_ && recordedProgram_.code.empty())
    recordedProgram_ = makeProgram(*model_, bindings_, layout_, memory_.data(), true);
}

void Engine::recordEvent(const Instruction& i, const OptionState& option, int depth) {
  switch (i.operation) {
    case Operation::recordOption:
      return recorder_->add(TraceEvent::Kind::option, i.index, depth);
    case Operation::recordRead:
      return recorder_->add(TraceEvent::Kind::read, i.index, *i.a);
    case Operation::recordArgument:
      return recorder_->add(TraceEvent::Kind::argument, i.index, *i.a);
    case Operation::recordHolds:
      return recorder_->add(TraceEvent::Kind::decide, i.index, 1);
    case Operation::recordHoldsNot:
      return recorder_->add(TraceEvent::Kind::decide, i.index, 0);
    case Operation::recordAssignment:
      return recorder_->add(TraceEvent::Kind::assign, i.index, *i.a);
    case Operation::recordBehavior:
      return recordBehavior(i.index, depth + 1);
    default:
      return recordState(option);
  }
}

void Engine::recordState(const OptionState& option) {
  recorder_->add(TraceEvent::Kind::state, option.state,
                 static_cast<double>(since(option.stateActivation, now_)));
  recorder_->add(TraceEvent::Kind::optionTime, option.option,
                 static_cast<double>(since(option.activation, now_)));
  const int first = layout_.optionParameters[at(option.option)];
  const auto count = static_cast<int>(model_->options[at(option.option)].parameters.size());
  for (int p = 0; p < count; ++p)
    recorder_->add(TraceEvent::Kind::parameter, p, memory_[at(first + p)]);
}

void Engine::recordBehavior(int index, int depth) {
  recorder_->add(TraceEvent::Kind::behavior, index, depth);
  const int first = layout_.behaviorParameters[at(index)];
  const std::vector<int>& order = bindings_.behaviors[at(index)].order;
  for (std::size_t p = 0; p < order.size(); ++p)
    recorder_->add(TraceEvent::Kind::parameter, static_cast<int>(p), memory_[at(first + order[p])]);
}

}  // namespace xabsl
