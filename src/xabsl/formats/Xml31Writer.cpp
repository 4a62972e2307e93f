#include <algorithm>

#include "xabsl/formats/Lowering.h"
#include "xabsl/formats/XmlTree.h"
#include "xabsl/formats/XmlWriter.h"

namespace xabsl {
namespace {

constexpr const char* doctypeFile = "symbol-and-basic-behavior-files.dtd";

bool stays(const syntax::Decision& decision) {
  return decision.kind == syntax::Decision::Kind::stay ||
         std::any_of(decision.arms.begin(), decision.arms.end(),
                     [](const syntax::Arm& arm) { return stays(*arm.decision); }) ||
         (decision.otherwise && stays(*decision.otherwise));
}

class Xml31Writer : public XmlWriter {
 public:
  Xml31Writer(const syntax::Program& program, const Model& model, Reporter& reporter)
      : XmlWriter({.space = xml::namespace31,
                   .xincludeSpace = "http://www.w3.org/2003/XInclude",
                   .schemas = "",
                   .rootDoctype = "<!DOCTYPE options [\n    ",
                   .functionReference = "symbol-ref",
                   .elseIf = false,
                   .keepsFolders = false,
                   .keepsConnections = false,
                   .includesAll = false,
                   .commentsFirst = false},
                  program, model, reporter) {}

 private:
  std::string optionDoctype(const std::string& /*entities*/) const override {
    return std::string("<!DOCTYPE symbol-and-basic-behavior-files SYSTEM \"../") + doctypeFile +
           "\">\n";
  }

  void writeOptions() override {
    XmlWriter::writeOptions();
    std::string text;
    for (const Included& included : included_)
      text += entityDeclaration(included.entity, included.path);
    finish(doctypeFile, "", text + optionsDeclaration());
  }

  // --- Declarations

  /// What a symbol or a parameter has.
  template <typename Declaration>
  static Attributes typed(const Declaration& declaration, const std::string& name) {
    Attributes attributes = {{"name", name}, {"description", std::string(declaration.doc)}};
    if (declaration.type.kind == ValueKind::enumeration)
      attributes.insert(attributes.begin() + 1,
                        {"enumeration", std::string(declaration.type.enumeration.text)});
    if (declaration.type.kind == ValueKind::number)
      attributes.insert(attributes.end(), {{"measure", std::string(declaration.unit)},
                                           {"range", std::string(declaration.range)}});
    return attributes;
  }

  void declare(const syntax::Enumeration& enumeration) override {
    Attributes attributes = named(enumeration);
    if (enumeration.internal) attributes.push_back({"internal", "true"});
    out_.open("enumeration", attributes);
    for (const syntax::Name& element : enumeration.elements)
      out_.empty("enum-element", {{"name", qualified(enumeration, element.text)}});
    out_.close("enumeration");
  }

  Attributes attributesOf(const syntax::Constant& constant) const override {
    const std::string sign = constant.negative ? "-" : "";
    return {{"name", std::string(constant.name.text)},
            {"value", sign + std::string(constant.digits)},
            {"measure", std::string(constant.unit)},
            {"description", std::string(constant.doc)}};
  }

  void declare(const syntax::Symbol& symbol) override {
    Attributes attributes = typed(symbol, std::string(symbol.name.text));
    if (symbol.kind == SymbolKind::internal) attributes.push_back({"internal", "true"});
    const bool input = symbol.kind == SymbolKind::input;
    function(kindOf(symbol.type.kind) + (input ? "-input-symbol" : "-output-symbol"), attributes,
             symbol.name.text, symbol.parameters);
  }

  void parameter(const syntax::Parameter& parameter, const std::string& name) override {
    comments(parameter.name.location);
    out_.empty(kindOf(parameter.type.kind) + "-parameter", typed(parameter, name));
  }

  // --- Options

  /// Only a state's own decision tree can express that it stays: then each has the whole.
  bool copiesCommon(const syntax::Decision& decision) const override { return stays(decision); }

  void commonActions(const syntax::Option& option, const Option& resolved) override {
    if (option.commonActions.empty()) return;
    out_.open("common-action", {});
    actions(option.commonActions, resolved.commonActions);
    out_.close("common-action");
  }

  void stateActions(const syntax::Option& /*option*/, const Option& /*resolvedOption*/,
                    const State& resolved) override {
    actions(state_->actions, resolved.actions);
  }

  void assignment(const ActionPair& action) override {
    const Symbol& symbol = model_.symbols[at(action.resolved.target)];
    use(symbol.space, false);
    const std::string element = "set-" + kindOf(symbol.type.kind) + "-output-symbol";
    out_.open(element, {{"ref", symbol.name}});
    expression(*action.source.value, action.resolved.operand);
    out_.close(element);
  }

  // --- Expressions

  std::string digits(const syntax::Expression& /*source*/, double value) const override {
    return decimalText(value);
  }

  std::optional<std::string> negated(const syntax::Expression& /*operand*/,
                                     const Expression& expression) const override {
    const auto value = signedNumber(model_, expression);
    return value ? std::optional{decimalText(*value)} : std::nullopt;
  }

  bool isComparison(const syntax::Expression& /*source*/,
                    const Expression& expression) const override {
    return isEnumerated(model_, expression.a);
  }

  void comparison(const syntax::Expression& source, int index) override {
    element("enumerated-input-symbol-comparison", source, index);
  }
};

}  // namespace

VirtualFiles writeXml31(const syntax::Program& program, const Model& model, const std::string& root,
                        Reporter& reporter) {
  return Xml31Writer(program, model, reporter).write(root);
}

}  // namespace xabsl
