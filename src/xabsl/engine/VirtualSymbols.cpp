#include "xabsl/engine/VirtualSymbols.h"

#include <string>
#include <utility>

namespace xabsl {

namespace {

RegisteredType registeredType(const Model& model, Type type) {
  RegisteredType registered;
  registered.kind = type.kind;
  if (type.kind != ValueKind::enumeration) return registered;
  registered.type = typeid(void);
  registered.enumeration = model.enumerations[at(type.enumeration)].name;
  return registered;
}

std::vector<RegisteredParameter> registeredParameters(const Model& model,
                                                      const std::vector<Parameter>& parameters) {
  std::vector<RegisteredParameter> registered;
  for (const Parameter& parameter : parameters)
    registered.push_back({parameter.name, registeredType(model, parameter.type)});
  return registered;
}

/// A shared pointer that does not own the object.
std::shared_ptr<void> unowned(void* object) {
  return {std::shared_ptr<void>(), object};
}

}  // namespace

VirtualSymbols::VirtualSymbols(const Model& model, Call call) : call_(std::move(call)) {
  for (const Enumeration& enumeration : model.enumerations) {
    std::vector<std::string> elements;
    for (const EnumerationElement& element : enumeration.elements) elements.push_back(element.name);
    symbols_.enumeration(enumeration.name, std::move(elements));
  }
  for (std::size_t i = 0; i < model.symbols.size(); ++i)
    entries_.push_back({this, static_cast<int>(i)});
  for (std::size_t i = 0; i < model.symbols.size(); ++i) {
    const Symbol& symbol = model.symbols[i];
    if (symbol.kind == SymbolKind::internal) continue;
    RegisteredFunction function = registered(entries_[i], symbol);
    function.type = registeredType(model, symbol.type);
    function.parameters = registeredParameters(model, symbol.parameters);
    if (symbol.kind == SymbolKind::input)
      symbols_.addInput(symbol.name, std::move(function));
    else
      symbols_.addOutput(symbol.name, std::move(function));
  }
  for (const BasicBehavior& behavior : model.behaviors) {
    RegisteredFunction function;
    function.function.call = [](void*, const double*) { return 0.0; };
    function.parameters = registeredParameters(model, behavior.parameters);
    symbols_.addBehavior(behavior.name, std::move(function));
  }
}

RegisteredFunction VirtualSymbols::registered(Entry& entry, const Symbol& symbol) {
  RegisteredFunction registered;
  registered.function.object = unowned(&entry);
  if (symbol.kind == SymbolKind::output)
    registered.function.call = [](void* object, const double* arguments) {
      static_cast<Entry*>(object)->value = *arguments;
      return 0.0;
    };
  else if (symbol.parameters.empty()) {
    registered.function.call = [](void* object, const double*) {
      return static_cast<Entry*>(object)->value;
    };
    registered.function.variable = variableOf(&entry.value);
  } else
    registered.function.call = [](void* object, const double* arguments) {
      const Entry& called = *static_cast<Entry*>(object);
      return called.owner->call_ ? called.owner->call_(called.symbol, arguments) : called.value;
    };
  return registered;
}

}  // namespace xabsl
