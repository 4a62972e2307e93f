#include <string>
#include <utility>
#include <vector>

#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/language/Lowering.h"

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
    owners("options", model_.options, sortedByName(model_.options));
    const auto behaviors = static_cast<int>(model_.behaviors.size());
    owners("basic behaviors", model_.behaviors, Span{0, behaviors});
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

  /// What has parameters; `order` lists indices.
  template <typename Owner, typename Order>
  void owners(const std::string& kind, const std::vector<Owner>& list, const Order& order) {
    line("// number of " + kind);
    line(std::to_string(list.size()));
    line("//" + kind +
         ": (name num-of-parameters (d decimal-parameter | b boolean_parameter | e "
         "enum-name enumerated-parameter)*)+");
    for (const int index : order) {
      const Owner& owner = list[at(index)];
      std::string text = owner.name + " " + std::to_string(owner.parameters.size()) + " ";
      for (const Parameter& parameter : owner.parameters)
        text += typedName(model_, parameter.type, owner.name + "." + parameter.name) + " ";
      line(text);
    }
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
