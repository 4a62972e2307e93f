#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/formats/IntermediateCode.h"

namespace xabsl {

namespace {

/// The sections of the file one after another, each with its headline as the first compilers wrote
/// them.
class Writer {
 public:
  explicit Writer(const Model& model) : model_(model) {}

  std::string run() {
    line("// Debug Symbols for the agents of " + model_.title);
    line("");
    enumerations();
    symbols(true, "input");
    symbols(false, "output");
    options();
    behaviors();
    return std::move(text_);
  }

 private:
  void line(const std::string& text) { text_ += text + "\r\n"; }

  void endSection() {
    line("");
    line("");
  }

  std::string typed(Type type, const std::string& name) const {
    if (type.kind == ValueKind::number) return "d " + name + " ";
    if (type.kind == ValueKind::boolean) return "b " + name + " ";
    return "e " + model_.enumerations[static_cast<std::size_t>(type.enumeration)].name + " " +
           name + " ";
  }

  void enumerations() {
    line("// number of enumerations");
    line(std::to_string(model_.enumerations.size()));
    line("// enumerations");
    line("// (name number-of-elements (element)*)+");
    for (const Enumeration& enumeration : model_.enumerations) {
      std::string text = enumeration.name + " " + std::to_string(enumeration.elements.size()) + " ";
      for (const EnumerationElement& element : enumeration.elements)
        text += enumeration.name + "." + element.name + " ";
      line(text);
    }
    endSection();
  }

  void symbols(bool inputs, const std::string& kind) {
    std::vector<const Symbol*> chosen;
    for (const Symbol& symbol : model_.symbols)
      if ((symbol.kind == SymbolKind::input) == inputs) chosen.push_back(&symbol);
    line("// number of " + kind + " symbols");
    line(std::to_string(chosen.size()));
    line("// " + kind + " symbols");
    line("// (d decimal-" + kind + "-symbol | b boolean-" + kind + "-symbol | e enum-name " +
         "enumerated-" + kind + "-symbol)+");
    for (const Symbol* symbol : chosen) line(typed(symbol->type, symbol->name));
    endSection();
  }

  void owner(const std::string& name, const std::vector<Parameter>& parameters) {
    std::string text = name + " " + std::to_string(parameters.size()) + " ";
    for (const Parameter& parameter : parameters)
      text += typed(parameter.type, name + "." + parameter.name);
    line(text);
  }

  void options() {
    line("// number of options");
    line(std::to_string(model_.options.size()));
    line(
        "//options: (name num-of-parameters (d decimal-parameter | b boolean_parameter | e "
        "enum-name enumerated-parameter)*)+");
    std::vector<const Option*> options;
    for (const Option& option : model_.options) options.push_back(&option);
    std::sort(options.begin(), options.end(), [](const Option* a, const Option* b) {
      return std::lexicographical_compare(
          a->name.begin(), a->name.end(), b->name.begin(), b->name.end(), [](char x, char y) {
            const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c + 0; };
            return lower(x) < lower(y);
          });
    });
    for (const Option* option : options) owner(option->name, option->parameters);
    endSection();
  }

  void behaviors() {
    line("// number of basic behaviors");
    line(std::to_string(model_.behaviors.size()));
    line(
        "//basic behaviors: (name num-of-parameters (d decimal-parameter | b boolean_parameter | e "
        "enum-name enumerated-parameter)*)+");
    for (const BasicBehavior& behavior : model_.behaviors)
      owner(behavior.name, behavior.parameters);
    endSection();
  }

  const Model& model_;
  std::string text_;
};

}  // namespace

std::string writeDebugSymbols(const Model& model) {
  return Writer(model).run();
}

}  // namespace xabsl
