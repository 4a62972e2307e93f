#include <charconv>
#include <map>
#include <utility>

#include "xabsl/engine/Engine.h"

/// The functions by which a person or a test overrides an engine (report H.8).
namespace xabsl {

bool Engine::selectAgent(std::string_view name) {
  const int index = indexOf(model_->agents, name);
  if (index < 0) return false;
  agent_ = static_cast<std::size_t>(index);
  select(Activation::Kind::option, model_->agents[agent_].rootOption);
  return true;
}

void Engine::resumeFrom(const Engine& other) {
  cycle_ = other.cycle_;
  now_ = other.now_;
  for (OptionState& option : options_) resumeFrom(other, option);
  for (std::size_t i = 0; i < model_->symbols.size(); ++i) {
    const Symbol& symbol = model_->symbols[i];
    const int before = other.model_->findOutput(symbol.name);
    if (symbol.kind == SymbolKind::input || before < 0) continue;
    const Symbol& old = other.model_->symbols[at(before)];
    if (old.kind == symbol.kind)
      take(other, old.type, other.variable(static_cast<std::size_t>(before)), symbol.type,
           variable(i));
  }
  cooperation_.configure(other.cooperation_.message().priority,
                         other.cooperation_.synchronizationTicks());
  cooperation_.countTeammatesOnly(other.cooperation_.countsTeammatesOnly());
  selectAgent(other.selectedAgent());
  if (other.rootKind_ == Activation::Kind::behavior)
    selectBehavior(other.model_->behaviors[at(other.root_)].name);
  else if (other.root_ != other.model_->agents[other.agent_].rootOption)
    selectRootOption(other.model_->options[at(other.root_)].name);
  const auto oldPlaces = other.parameterPlaces();
  for (const auto& [name, parameter] : parameterPlaces())
    if (const auto old = oldPlaces.find(name); old != oldPlaces.end())
      take(other, old->second.type, other.memory_[at(old->second.index)], parameter.type,
           memory_[at(parameter.index)]);
}

/// Resumes an option that was active in a state that still exists.
void Engine::resumeFrom(const Engine& other, OptionState& option) {
  const Option& declared = model_->options[at(option.option)];
  const int before = indexOf(other.model_->options, declared.name);
  if (before < 0) return;
  const OptionState& old = other.options_[at(before)];
  if (old.state < 0) return;
  const std::string& state = other.model_->states[at(old.state)].name;
  for (const int i : declared.states) {
    if (model_->states[at(i)].name != state) continue;
    const int index = option.option;
    option = old;
    option.option = index;
    option.state = i;
  }
}

/// Copies a value by its text, because elements may have changed their order; ignores values of
/// another type.
void Engine::take(const Engine& other, Type oldType, double oldValue, Type type, double& value) {
  if (oldType.kind == type.kind)
    value = read(type, other.named({}, oldType, oldValue).text).value_or(value);
}

/// All parameters by their names.
std::map<std::string, Engine::ParameterPlace> Engine::parameterPlaces() const {
  std::map<std::string, ParameterPlace> places;
  for (std::size_t i = 0; i < model_->options.size(); ++i) {
    const Option& option = model_->options[i];
    int place = layout_.optionParameters[i];
    for (const Parameter& parameter : option.parameters)
      places["option " + option.name + " " + parameter.name] = {parameter.type, place++};
  }
  for (std::size_t i = 0; i < model_->behaviors.size(); ++i) {
    const BasicBehavior& behavior = model_->behaviors[i];
    const int first = layout_.behaviorParameters[i];
    const int* order = bindings_.behaviors[i].order.data();
    for (const Parameter& parameter : behavior.parameters)
      places["behavior " + behavior.name + " " + parameter.name] = {parameter.type,
                                                                    first + *order++};
  }
  return places;
}

bool Engine::selectRootOption(std::string_view name) {
  return select(Activation::Kind::option, indexOf(model_->options, name));
}

bool Engine::selectBehavior(std::string_view name) {
  return select(Activation::Kind::behavior, indexOf(model_->behaviors, name));
}

/// Resets the parameters of the root to their first values.
bool Engine::select(Activation::Kind kind, int index) {
  if (index < 0) return false;
  rootKind_ = kind;
  root_ = index;
  const std::vector<Parameter>& parameters = rootParameters();
  for (std::size_t p = 0; p < parameters.size(); ++p) rootSlot(p) = firstValue(parameters[p].type);
  return true;
}

const std::vector<Parameter>& Engine::rootParameters() const {
  const auto index = static_cast<std::size_t>(root_);
  return rootKind_ == Activation::Kind::option ? model_->options[index].parameters
                                               : model_->behaviors[index].parameters;
}

double& Engine::rootSlot(std::size_t parameter) {
  const auto index = static_cast<std::size_t>(root_);
  const int place =
      rootKind_ == Activation::Kind::option
          ? layout_.optionParameters[index] + static_cast<int>(parameter)
          : layout_.behaviorParameters[index] + bindings_.behaviors[index].order[parameter];
  return memory_[at(place)];
}

bool Engine::setParameter(std::string_view name, std::string_view value) {
  const std::vector<Parameter>& parameters = rootParameters();
  const int index = indexOf(parameters, name);
  if (index < 0) return false;
  const auto parameter = static_cast<std::size_t>(index);
  const std::optional<double> number = read(parameters[parameter].type, value);
  if (!number) return false;
  const double before = std::exchange(rootSlot(parameter), *number);
  if (rootKind_ == Activation::Kind::behavior && before != *number)
    notifyOfChanges(static_cast<std::size_t>(root_));
  return true;
}

bool Engine::setOutput(std::string_view name, std::string_view value) {
  const int index = model_->findOutput(name);
  if (index < 0) return false;
  const auto symbol = static_cast<std::size_t>(index);
  const std::optional<double> number = read(model_->symbols[symbol].type, value);
  if (!number) return false;
  variable(symbol) = *number;
  apply(symbol);
  return true;
}

std::optional<NamedValue> Engine::symbol(std::string_view name,
                                         const std::vector<Argument>& arguments) const {
  const int index = model_->findInput(name);
  if (index < 0 || model_->symbols[at(index)].parameters.empty())
    return arguments.empty() ? this->symbol(name) : std::nullopt;
  const auto i = static_cast<std::size_t>(index);
  const Symbol& symbol = model_->symbols[i];
  std::vector<double> values(symbol.parameters.size());
  const std::vector<int>& order = bindings_.symbols[i].order;
  for (std::size_t p = 0; p < values.size(); ++p)
    values[at(order[p])] = firstValue(symbol.parameters[p].type);
  for (const Argument& argument : arguments) {
    const int parameter = indexOf(symbol.parameters, argument.parameter);
    if (parameter < 0) return std::nullopt;
    const auto p = static_cast<std::size_t>(parameter);
    const std::optional<double> value = read(symbol.parameters[p].type, argument.value);
    if (!value) return std::nullopt;
    values[at(order[p])] = *value;
  }
  return named(symbol.name, symbol.type, callInput(i, values.data()));
}

std::optional<double> Engine::read(Type type, std::string_view text) const {
  if (type.kind == ValueKind::boolean) {
    if (text != "true" && text != "false") return std::nullopt;
    return text == "true" ? 1 : 0;
  }
  if (type.kind == ValueKind::enumeration) {
    const auto enumeration = static_cast<std::size_t>(type.enumeration);
    const int element = indexOf(model_->enumerations[enumeration].elements, text);
    if (element < 0) return std::nullopt;
    return bindings_.elements[enumeration][at(element)];
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace xabsl
