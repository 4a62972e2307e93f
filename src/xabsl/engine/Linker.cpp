#include "xabsl/engine/Linker.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

namespace {

class Linker {
 public:
  Linker(const Model& model, const Symbols& symbols) : model_(model), symbols_(symbols) {
    for (const std::string& file : model.files) reporter_.addFile(file);
  }

  Bindings run() {
    Bindings bindings;
    for (const Enumeration& enumeration : model_.enumerations) {
      bindings.elements.push_back(elements(enumeration));
      bindings.firstElements.push_back(firstElement(enumeration));
    }
    for (const Symbol& symbol : model_.symbols) bindings.symbols.push_back(bind(symbol));
    for (const BasicBehavior& behavior : model_.behaviors)
      bindings.behaviors.push_back(bind(behavior));
    return bindings;
  }

  std::vector<Diagnostic> diagnostics() { return reporter_.take(); }

 private:
  std::vector<double> elements(const Enumeration& enumeration) {
    const RegisteredEnumeration* registered = symbols_.findEnumeration(enumeration.name);
    std::vector<double> values;
    for (const EnumerationElement& element : enumeration.elements) {
      // An enumeration that only internal symbols use need not be registered.
      if (!registered) {
        values.push_back(static_cast<double>(values.size()));
        continue;
      }
      const auto found =
          std::find(registered->elements.begin(), registered->elements.end(), element.name);
      if (found == registered->elements.end()) missingElement(enumeration, element, *registered);
      values.push_back(static_cast<double>(found - registered->elements.begin()));
    }
    return values;
  }

  double firstElement(const Enumeration& enumeration) const {
    const RegisteredEnumeration* registered = symbols_.findEnumeration(enumeration.name);
    if (!registered) return 0;
    // Values may have gaps, which have no names.
    const auto first = std::find_if(registered->elements.begin(), registered->elements.end(),
                                    [](const std::string& name) { return !name.empty(); });
    return static_cast<double>(first - registered->elements.begin());
  }

  void missingElement(const Enumeration& enumeration, const EnumerationElement& element,
                      const RegisteredEnumeration& registered) {
    Suggestion suggestion(element.name);
    for (const std::string& candidate : registered.elements) suggestion.offer(candidate);
    reporter_.error(element.location, "element " + inQuotes(element.name) + " of enumeration " +
                                          inQuotes(enumeration.name) + " is not registered" +
                                          suggestion.text());
  }

  Bindings::Bound bind(const Symbol& symbol) {
    if (symbol.kind == SymbolKind::internal) return {};
    const bool input = symbol.kind == SymbolKind::input;
    const std::string what = (input ? "input symbol " : "output symbol ") + inQuotes(symbol.name);
    const RegisteredFunction* registered =
        input ? symbols_.findInput(symbol.name) : symbols_.findOutput(symbol.name);
    if (!registered) {
      missing(symbol.location, symbol.firstUse, what, symbol.name,
              input ? symbols_.inputs() : symbols_.outputs());
      return {};
    }
    checkType(symbol.location, symbol.firstUse, what, symbol.type, registered->type);
    return bind(*registered, symbol.parameters, symbol.location, symbol.firstUse, what);
  }

  Bindings::Bound bind(const BasicBehavior& behavior) {
    const std::string what = "basic behavior " + inQuotes(behavior.name);
    const RegisteredFunction* registered = symbols_.findBehavior(behavior.name);
    if (!registered) {
      missing(behavior.location, behavior.firstUse, what, behavior.name, symbols_.behaviors());
      return {};
    }
    return bind(*registered, behavior.parameters, behavior.location, behavior.firstUse, what);
  }

  Bindings::Bound bind(const RegisteredFunction& registered,
                       const std::vector<Parameter>& parameters, Location location, Use use,
                       const std::string& what) {
    Bindings::Bound bound{registered.function, {}, registered.parametersChanged};
    for (const Parameter& parameter : parameters) {
      const int index = indexOf(registered.parameters, parameter.name);
      const std::string name = "parameter " + inQuotes(parameter.name) + " of " + what;
      bound.order.push_back(index);
      if (index < 0)
        error(parameter.location, use, name + " is not registered");
      else
        checkType(parameter.location, use, name, parameter.type,
                  registered.parameters[at(index)].type);
    }
    for (const RegisteredParameter& parameter : registered.parameters)
      if (indexOf(parameters, parameter.name) < 0)
        error(location, use,
              "parameter " + inQuotes(parameter.name) + " of " + what +
                  " is registered, but not declared");
    return bound;
  }

  void checkType(Location location, Use use, const std::string& what, Type declared,
                 const RegisteredType& registered) {
    std::string name = registered.kind == ValueKind::number    ? "float"
                       : registered.kind == ValueKind::boolean ? "bool"
                                                               : "";
    if (registered.kind == ValueKind::enumeration) {
      name = symbols_.enumerationName(registered);
      if (name.empty() || !symbols_.findEnumeration(name))
        return error(location, use, what + " is registered with an enumeration that is not");
      name = "enum " + name;
    }
    if (name != describe(model_, declared))
      error(location, use,
            what + " is declared as " + describe(model_, declared) + ", but registered as " + name);
  }

  void missing(Location location, Use use, const std::string& what, const std::string& name,
               const std::map<std::string, RegisteredFunction>& candidates) {
    Suggestion suggestion(name);
    for (const auto& [candidate, function] : candidates) suggestion.offer(candidate);
    error(location, use, what + " is not registered", suggestion.text());
  }

  /// Reports besides which option needs what is wrong.
  void error(Location location, Use use, std::string message, const std::string& suggestion = {}) {
    if (use.option >= 0)
      message += ", needed by option " + model_.options[at(use.option)].name + " (" +
                 model_.files[at(use.location.file)] + ":" + std::to_string(use.location.line) +
                 ")";
    reporter_.error(location, message + suggestion);
  }

  const Model& model_;
  const Symbols& symbols_;
  Reporter reporter_;
};

}  // namespace

Bindings link(const Model& model, const Symbols& symbols, std::vector<Diagnostic>& diagnostics) {
  Linker linker(model, symbols);
  Bindings bindings = linker.run();
  for (Diagnostic& diagnostic : linker.diagnostics()) diagnostics.push_back(std::move(diagnostic));
  return bindings;
}

}  // namespace xabsl
