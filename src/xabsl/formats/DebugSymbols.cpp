#include <string>
#include <utility>
#include <vector>

#include "xabsl/formats/IntermediateCode.h"
#include "xabsl/formats/Lowering.h"

namespace xabsl {

namespace {

/// The sections of the file one after another, each with its headline as the first compilers wrote
/// them.
class DebugSymbolsWriter {
 public:
  explicit DebugSymbolsWriter(const Model& model) : model_(model) {}

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
    for (const Symbol* symbol : chosen) line(typedName(model_, symbol->type, symbol->name) + " ");
    endSection();
  }

  void owner(const std::string& name, const std::vector<Parameter>& parameters) {
    std::string text = name + " " + std::to_string(parameters.size()) + " ";
    for (const Parameter& parameter : parameters)
      text += typedName(model_, parameter.type, name + "." + parameter.name) + " ";
    line(text);
  }

  void options() {
    line("// number of options");
    line(std::to_string(model_.options.size()));
    line(
        "//options: (name num-of-parameters (d decimal-parameter | b boolean_parameter | e "
        "enum-name enumerated-parameter)*)+");
    for (const int option : sortedByName(model_.options))
      owner(model_.options[at(option)].name, model_.options[at(option)].parameters);
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
  return DebugSymbolsWriter(model).run();
}

}  // namespace xabsl
