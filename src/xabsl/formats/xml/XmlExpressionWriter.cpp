#include "xabsl/formats/xml/XmlExpressionWriter.h"

#include <charconv>
#include <optional>

#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Lowering.h"
#include "xabsl/language/ModelText.h"
#include "xabsl/language/Operators.h"

namespace xabsl {

void XmlExpressionWriter::use(int space, bool behaviors) {
  used_.insert({program_.namespaces[at(space)].name.text, behaviors});
}

void XmlExpressionWriter::refuse(Location location, const std::string& what) {
  if (refused_.insert({location.file, location.line, location.column, what}).second)
    reporter_.error(location, "XABSL 2.1 cannot say this: " + what);
}

std::string XmlExpressionWriter::kindOf(ValueKind kind) {
  return kind == ValueKind::number    ? "decimal"
         : kind == ValueKind::boolean ? "boolean"
                                      : "enumerated";
}

std::string XmlExpressionWriter::qualified(const syntax::Enumeration& enumeration,
                                           std::string_view element) {
  const std::string prefix = std::string(enumeration.name.text) + ".";
  return element.starts_with(prefix) ? std::string(element) : prefix + std::string(element);
}

std::string XmlExpressionWriter::elementName(std::string_view symbol,
                                             const syntax::Enumeration& enumeration,
                                             std::string_view element) {
  return symbol == enumeration.name.text ? std::string(element) : qualified(enumeration, element);
}

std::string XmlExpressionWriter::elementName(std::string_view symbol,
                                             const Expression& element) const {
  const syntax::Enumeration& enumeration = program_.enumerations[at(element.a)];
  return elementName(symbol, enumeration, enumeration.elements[at(element.b)].text);
}

std::string XmlExpressionWriter::withoutExponent(std::string_view text) {
  if (text.find_first_of("eE") == std::string_view::npos) return std::string(text);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  char buffer[800];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr;
  return {buffer, end};
}

void XmlExpressionWriter::expression(const syntax::Expression& source) {
  const Expression& expression = resolved(source);
  const std::string_view missing = old_ ? missingFor(expression) : "";
  if (!missing.empty()) return refuse(source.location, std::string(missing));
  switch (expression.operation) {
    case Operator::constant:
      return constant(source);
    case Operator::element: {
      const Enumeration& enumeration = model_.enumerations[at(expression.a)];
      use(enumeration.space, false);
      return out_.empty(
          "enum-element-ref",
          {{"ref", enumeration.name + "." + enumeration.elements[at(expression.b)].name}});
    }
    case Operator::parameter: {
      const Option& option = model_.options[at(expression.a)];
      return out_.empty("option-parameter-ref",
                        {{"ref", option.name + "." + option.parameters[at(expression.b)].name}});
    }
    case Operator::input:
    case Operator::variable:
      return symbol(source);
    case Operator::stateTime:
      return out_.empty("time-of-state-execution");
    case Operator::optionTime:
      return out_.empty("time-of-option-execution");
    case Operator::actionDone:
      return out_.empty("subsequent-option-reached-target-state");
    case Operator::conflict:
      return out_.empty("conflict");
    case Operator::negate:
      return negation(source);
    case Operator::conditional:
      return conditional(source);
    default:
      operation(source);
  }
}

/// Names the construct of an expression that 2.1 does not have; empty if 2.1 has it.
std::string_view XmlExpressionWriter::missingFor(const Expression& expression) const {
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

void XmlExpressionWriter::constant(const syntax::Expression& source) {
  const Expression& expression = resolved(source);
  if (expression.a >= 0) {
    const Constant& constant = model_.constants[at(expression.a)];
    use(constant.space, false);
    return out_.empty("constant-ref", {{"ref", constant.name}});
  }
  if (expression.b < 0)
    return number(old_ ? withoutExponent(source.name) : decimalText(expression.number));
  out_.empty("boolean-value", {{"value", expression.number != 0 ? "true" : "false"}});
}

void XmlExpressionWriter::number(const std::string& value) {
  out_.empty("decimal-value", {{"value", value}});
}

void XmlExpressionWriter::symbol(const syntax::Expression& source) {
  const Expression& expression = resolved(source);
  const Symbol& symbol = model_.symbols[at(expression.a)];
  use(symbol.space, false);
  const char* kind = expression.operation == Operator::input ? "-input-" : "-output-";
  const char* reference = old_ && !symbol.parameters.empty() ? "function-call" : "symbol-ref";
  call(kindOf(symbol.type.kind) + kind + reference, "with-parameter", symbol.name,
       symbol.parameters, source.arguments);
}

void XmlExpressionWriter::call(const std::string& element, const char* inner, std::string_view name,
                               const std::vector<Parameter>& parameters,
                               const std::vector<syntax::Argument>& arguments) {
  const xml::Attributes reference = {{"ref", std::string(name)}};
  if (arguments.empty()) return out_.empty(element, reference);
  out_.open(element, reference);
  for (const syntax::Argument& argument : arguments) {
    const int parameter = findParameter(parameters, argument.name.text, name);
    out_.open(inner, {{"ref", std::string(name) + "." + parameters[at(parameter)].name}});
    expression(*argument.value);
    out_.close(inner);
  }
  out_.close(element);
}

/// Writes the sign with a number; any other operand is subtracted from 0.
void XmlExpressionWriter::negation(const syntax::Expression& source) {
  const syntax::Expression& operand = *source.operands.front();
  if (old_ && operand.kind == syntax::Expression::Kind::number)
    return number("-" + withoutExponent(operand.name));
  const std::optional<double> value = old_ ? std::nullopt : signedNumber(model_, resolved(source));
  if (value) return number(decimalText(*value));
  out_.open("minus");
  number("0");
  expression(operand);
  out_.close("minus");
}

void XmlExpressionWriter::conditional(const syntax::Expression& source) {
  constexpr const char* names[] = {"condition", "expression1", "expression2"};
  out_.open("conditional-expression");
  for (std::size_t i = 0; i < 3; ++i) {
    out_.open(names[i]);
    expression(*source.operands[i]);
    out_.close(names[i]);
  }
  out_.close("conditional-expression");
}

void XmlExpressionWriter::operation(const syntax::Expression& source) {
  const std::string element(spellingOf(source.operation).element);
  if (source.operation == Operator::equal || source.operation == Operator::notEqual)
    return equality(source, element);
  out_.open(element);
  operands(source);
  out_.close(element);
}

/// Enumerations are compared by a separate XML element; in 2.1 only an input symbol with an
/// element.
void XmlExpressionWriter::equality(const syntax::Expression& source, const std::string& element) {
  const Expression& left = resolved(*source.operands[0]);
  const Expression& right = resolved(*source.operands[1]);
  const bool enumerated =
      old_ ? left.operation == Operator::input && source.operands[0]->arguments.empty() &&
                 right.operation == Operator::element
           : typeOf(model_, source.operands[0]->resolved).kind == ValueKind::enumeration;
  const bool negated = enumerated && source.operation == Operator::notEqual;
  const std::string name = enumerated ? "enumerated-input-symbol-comparison" : element;
  if (negated) out_.open("not");
  if (enumerated && old_) {
    const std::string& symbol = model_.symbols[at(left.a)].name;
    out_.empty(name, {{"ref", symbol}, {"value", elementName(symbol, right)}});
  } else {
    out_.open(name);
    operands(source);
    out_.close(name);
  }
  if (negated) out_.close("not");
}

/// In 3.1 nested `&&` are merged into one, and so are nested `||`.
void XmlExpressionWriter::operands(const syntax::Expression& source) {
  const bool connection =
      source.operation == Operator::logicalAnd || source.operation == Operator::logicalOr;
  for (const syntax::ExpressionPtr& operand : source.operands) {
    if (connection && !old_ && operand->operation == source.operation)
      operands(*operand);
    else
      expression(*operand);
  }
}

}  // namespace xabsl
