#include <algorithm>
#include <charconv>
#include <tuple>

#include "xabsl/formats/XmlTree.h"
#include "xabsl/formats/XmlWriter.h"

namespace xabsl {
namespace {

/// A number without exponent, which the schema of 2.1 does not know.
std::string withoutExponent(std::string_view text) {
  if (text.find_first_of("eE") == std::string_view::npos) return std::string(text);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  char buffer[800];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr;
  return {buffer, end};
}

/// In 2.1, elements have the name of their enumeration before them, if it is not that of the
/// symbol: so symbols of one type are of one type again.
class Xml21Writer : public XmlWriter {
 public:
  Xml21Writer(const syntax::Program& program, const Model& model, Reporter& reporter)
      : XmlWriter({.space = xml::namespace21,
                   .xincludeSpace = "http://www.w3.org/2001/XInclude",
                   .schemas = "xabsl-2.1.",
                   .rootDoctype = "<!DOCTYPE agent-collection [\n  ",
                   .functionReference = "function-call",
                   .elseIf = true,
                   .keepsFolders = true,
                   .keepsConnections = true,
                   .includesAll = true,
                   .commentsFirst = true},
                  program, model, reporter) {}

 private:
  /// XABSL 2.1 has no way to express something.
  void refuse(Location location, const std::string& what) {
    // Actions common to all states are written in each of them.
    if (refused_.insert({location.file, location.line, location.column, what}).second)
      reporter_.error(location, "XABSL 2.1 cannot say this: " + what);
  }

  std::string optionDoctype(const std::string& entities) const override {
    return "<!DOCTYPE option [\n" + entities + "]>\n";
  }

  // --- Declarations

  /// Is declared with each symbol.
  void declare(const syntax::Enumeration& enumeration) override {
    if (!enumeration.doc.empty()) out_.comment(enumeration.doc);
  }

  Attributes attributesOf(const syntax::Constant& constant) const override {
    Attributes attributes = named(constant);
    attributes.push_back({"measure", std::string(constant.unit)});
    attributes.push_back(
        {"value", (constant.negative ? "-" : "") + withoutExponent(constant.digits)});
    return attributes;
  }

  void declare(const syntax::Symbol& symbol) override {
    const Location place = symbol.name.location;
    const bool input = symbol.kind == SymbolKind::input;
    const bool enumerated = symbol.type.kind == ValueKind::enumeration;
    if (!symbol.range.empty())
      reporter_.warning(place, "XABSL 2.1 has no ranges of symbols; that of " +
                                   inQuotes(symbol.name.text) + " is left out");
    if (symbol.kind == SymbolKind::internal) return refuse(place, "an internal symbol");
    if (!input && !enumerated) return refuse(place, "an output symbol that is not enumerated");
    if (symbol.type.kind != ValueKind::number && !symbol.parameters.empty())
      return refuse(place, enumerated ? "an enumerated symbol with parameters"
                                      : "a boolean symbol with parameters");
    if (enumerated) return declareEnumerated(symbol, input);
    Attributes attributes = named(symbol);
    if (symbol.type.kind == ValueKind::boolean)
      return out_.empty("boolean-input-symbol", attributes);
    attributes.push_back({"measure", std::string(symbol.unit)});
    function(symbol.parameters.empty() ? "decimal-input-symbol" : "decimal-input-function",
             attributes, symbol.name.text, symbol.parameters);
  }

  void declareEnumerated(const syntax::Symbol& symbol, bool input) {
    const std::string element = input ? "enumerated-input-symbol" : "enumerated-output-symbol";
    const auto found = std::find_if(program_.enumerations.begin(), program_.enumerations.end(),
                                    [&](const syntax::Enumeration& candidate) {
                                      return candidate.name.text == symbol.type.enumeration.text;
                                    });
    declared_.insert(&*found);
    if (found->internal) refuse(found->name.location, "an internal enumeration");
    out_.open(element, named(symbol));
    for (const syntax::Name& name : found->elements)
      out_.empty("enum-element", {{"name", elementName(symbol.name.text, *found, name.text)}});
    out_.close(element);
  }

  static std::string elementName(std::string_view symbol, const syntax::Enumeration& enumeration,
                                 std::string_view element) {
    return symbol == enumeration.name.text ? std::string(element) : qualified(enumeration, element);
  }

  void parameter(const syntax::Parameter& parameter, const std::string& name) override {
    if (parameter.type.kind != ValueKind::number)
      refuse(parameter.name.location, "a parameter that is not decimal");
    comments(parameter.extent.begin);
    out_.empty("parameter", {{"name", name},
                             {"measure", std::string(parameter.unit)},
                             {"range", std::string(parameter.range)},
                             {"description", std::string(parameter.doc)}});
  }

  // --- Options

  void writeOptions() override {
    for (const syntax::Enumeration& enumeration : program_.enumerations)
      if (declared_.count(&enumeration) == 0)
        refuse(enumeration.name.location, "an enumeration without a symbol of its type");
    std::stable_partition(included_.begin(), included_.end(),
                          [](const Included& included) { return !included.behaviors; });
    XmlWriter::writeOptions();
  }

  bool copiesCommon(const syntax::Decision& /*decision*/) const override { return false; }

  /// One option or basic behavior; output symbols are set before it, as if the state had been asked
  /// first (F.6). Actions common to all states stand in each of them.
  void stateActions(const syntax::Option& option, const Option& resolvedOption,
                    const State& resolved) override {
    if (state_->cooperation.kind != Cooperation::Kind::none)
      refuse(state_->name.location, "a state in which robots cooperate");
    std::vector<ActionPair> all = pairs(option.commonActions, resolvedOption.commonActions);
    for (const ActionPair& own : pairs(state_->actions, resolved.actions)) all.push_back(own);
    const ActionPair* called = nullptr;
    for (const ActionPair& action : all) {
      const bool assignment = action.resolved.kind == Action::Kind::assignment;
      if (!assignment && called)
        refuse(action.source.name.location, "a second option or basic behavior in a state");
      if (assignment && called && called->resolved.kind == Action::Kind::option)
        refuse(action.source.name.location, "an output symbol set after an option is called");
      if (!assignment) called = &action;
    }
    if (!called) return refuse(state_->name.location, "a state without option or basic behavior");
    action(*called);
    for (const ActionPair& action : all)
      if (action.resolved.kind == Action::Kind::assignment) this->action(action);
  }

  void assignment(const ActionPair& action) override {
    const Symbol& symbol = model_.symbols[at(action.resolved.target)];
    const Expression& value = model_.expressions[at(action.resolved.operand)];
    if (symbol.type.kind != ValueKind::enumeration) return;  // its declaration is refused
    if (value.operation != Operator::element)
      return refuse(action.source.value->location, "a value that is not an element of its symbol");
    out_.empty("set-output-symbol",
               {{"ref", symbol.name}, {"value", elementName(symbol.name, value)}});
  }

  void decision(const Tree& tree, const Tree* rest) override {
    if (tree.source) {
      comments(tree.source->extent.begin);
      if (tree.source->kind == syntax::Decision::Kind::stay && !state_)
        return refuse(tree.source->extent.begin, "'stay' in a decision tree common to all states");
    }
    XmlWriter::decision(tree, rest);
  }

  // --- Expressions

  void expression(const syntax::Expression& source, int index) override {
    const std::string_view missing = missingFor(model_.expressions[at(index)]);
    if (!missing.empty()) return refuse(source.location, std::string(missing));
    XmlWriter::expression(source, index);
  }

  /// What 2.1 does not have; empty if it has the expression.
  std::string_view missingFor(const Expression& expression) const {
    switch (expression.operation) {
      case Operator::constant:
        return expression.a < 0 && expression.b >= 0 ? "'true' and 'false' in an expression" : "";
      case Operator::element:
        return "an element of an enumeration as a value";
      case Operator::variable:
        return "an output symbol that is read";
      case Operator::input:
        return model_.symbols[at(expression.a)].type.kind == ValueKind::enumeration
                   ? "an enumerated symbol that is not compared with an element"
                   : "";
      case Operator::conflict:
        return "'conflict'";
      default:
        return "";
    }
  }

  std::string digits(const syntax::Expression& source, double /*value*/) const override {
    return withoutExponent(source.name);
  }

  std::optional<std::string> negated(const syntax::Expression& operand,
                                     const Expression& /*expression*/) const override {
    if (operand.kind != syntax::Expression::Kind::number) return std::nullopt;
    return "-" + withoutExponent(operand.name);
  }

  /// An enumerated input symbol compared with one of its elements.
  bool isComparison(const syntax::Expression& source, const Expression& expression) const override {
    return model_.expressions[at(expression.a)].operation == Operator::input &&
           source.operands.front()->arguments.empty() &&
           model_.expressions[at(expression.b)].operation == Operator::element;
  }

  void comparison(const syntax::Expression& /*source*/, int index) override {
    const Expression& expression = model_.expressions[at(index)];
    const std::string& symbol = model_.symbols[at(model_.expressions[at(expression.a)].a)].name;
    out_.empty(
        "enumerated-input-symbol-comparison",
        {{"ref", symbol}, {"value", elementName(symbol, model_.expressions[at(expression.b)])}});
  }

  std::string elementName(std::string_view symbol, const Expression& element) const {
    const syntax::Enumeration& enumeration = program_.enumerations[at(element.a)];
    return elementName(symbol, enumeration, enumeration.elements[at(element.b)].text);
  }

  std::set<const syntax::Enumeration*> declared_;  // with a symbol
  std::set<std::tuple<int, int, int, std::string>> refused_;
};

}  // namespace

VirtualFiles writeXml21(const syntax::Program& program, const Model& model, const std::string& root,
                        Reporter& reporter) {
  return Xml21Writer(program, model, reporter).write(root);
}

}  // namespace xabsl
