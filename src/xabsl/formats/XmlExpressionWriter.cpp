#include "xabsl/formats/XmlExpressionWriter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include "xabsl/formats/XmlOperators.h"

namespace xabsl {

using namespace syntax;
using xml::Attributes;

namespace {

std::string_view elementOf(Operator operation) {
  return std::find_if(std::begin(xml::operators), std::end(xml::operators),
                      [&](const xml::OperatorElement& e) { return e.operation == operation; })
      ->name;
}

std::string qualified(const Enumeration& enumeration, std::string_view element) {
  const std::string prefix = std::string(enumeration.name.text) + ".";
  return element.substr(0, prefix.size()) == prefix ? std::string(element)
                                                    : prefix + std::string(element);
}

}  // namespace

XmlExpressionWriter::XmlExpressionWriter(const Program& program, Reporter& reporter,
                                         xml::XmlOutput& out)
    : reporter_(reporter), out_(out) {
  for (const Symbol& symbol : program.symbols)
    (symbol.kind == SymbolKind::input ? inputs_ : outputs_).emplace(symbol.name.text, &symbol);
  for (const Constant& constant : program.constants) constants_.insert(constant.name.text);
  for (const Option& option : program.options) options_.insert(option.name.text);
  for (const Enumeration& enumeration : program.enumerations)
    enumerations_.emplace(enumeration.name.text, &enumeration);
}

void XmlExpressionWriter::cannot(Location location, const std::string& what) {
  // Actions common to all states are written in each of them.
  const auto told = std::tuple(location.file, location.line, location.column, what);
  if (!told_.insert(told).second) return;
  reporter_.error(location, "XABSL 2.1 cannot say this: " + what);
}

const Symbol* XmlExpressionWriter::find(const SymbolTable& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? nullptr : found->second;
}

const Enumeration* XmlExpressionWriter::enumerationOf(const Symbol& symbol) const {
  if (symbol.type.kind != ValueKind::enumeration) return nullptr;
  const auto found = enumerations_.find(symbol.type.enumeration.text);
  return found == enumerations_.end() ? nullptr : found->second;
}

std::string XmlExpressionWriter::elementName(const Symbol& symbol, const Enumeration& enumeration,
                                             std::string_view element) {
  if (symbol.name.text != enumeration.name.text) return qualified(enumeration, element);
  for (const Name& candidate : enumeration.elements)
    if (qualified(enumeration, candidate.text) == qualified(enumeration, element))
      return std::string(candidate.text);
  return std::string(element);
}

bool XmlExpressionWriter::isElement(const Enumeration& enumeration, const Expression& value) {
  return value.kind == Expression::Kind::name &&
         std::any_of(
             enumeration.elements.begin(), enumeration.elements.end(), [&](const Name& element) {
               return qualified(enumeration, element.text) == qualified(enumeration, value.name);
             });
}

std::string XmlExpressionWriter::digits(std::string_view text) {
  if (text.find_first_of("eE") == std::string_view::npos) return std::string(text);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  std::array<char, 800> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
          .ptr;
  return {buffer.data(), end};
}

void XmlExpressionWriter::write(const Expression& expression) {
  using Kind = Expression::Kind;
  switch (expression.kind) {
    case Kind::number:
      return out_.empty("decimal-value", {{"value", digits(expression.name)}});
    case Kind::parameter: {
      const std::string owner(option_->name.text);
      return out_.empty("option-parameter-ref",
                        {{"ref", owner + "." + std::string(expression.name)}});
    }
    case Kind::stateTime:
      return out_.empty("time-of-state-execution", {});
    case Kind::optionTime:
      return out_.empty("time-of-option-execution", {});
    case Kind::actionDone:
      return out_.empty("subsequent-option-reached-target-state", {});
    case Kind::boolean:
      return cannot(expression.location, "'true' and 'false' in an expression");
    case Kind::conflict:
      return cannot(expression.location, "'conflict'");
    case Kind::operation:
      return operation(expression);
    default:
      return reference(expression);
  }
}

void XmlExpressionWriter::reference(const Expression& expression) {
  const Attributes ref = {{"ref", std::string(expression.name)}};
  const bool called = expression.kind == Expression::Kind::call;
  if (!called && constants_.count(expression.name) > 0) return out_.empty("constant-ref", ref);
  const Symbol* const found = find(inputs_, expression.name);
  if (!found && output(expression.name))
    return cannot(expression.location, "an output symbol that is read");
  if (!found) return cannot(expression.location, "an element of an enumeration as a value");
  const Symbol& symbol = *found;
  if (symbol.type.kind == ValueKind::boolean) return out_.empty("boolean-input-symbol-ref", ref);
  if (symbol.type.kind == ValueKind::enumeration)
    return cannot(expression.location, "an enumerated symbol that is not compared with an element");
  if (symbol.parameters.empty()) return out_.empty("decimal-input-symbol-ref", ref);
  writeValues("decimal-input-function-call", "with-parameter", expression.name,
              expression.arguments);
}

void XmlExpressionWriter::operation(const Expression& expression) {
  if (expression.operation == Operator::negate) return negation(expression);
  if (expression.operation == Operator::conditional) return conditional(expression);
  if (comparison(expression)) return;
  const std::string name(elementOf(expression.operation));
  out_.open(name, {});
  for (const ExpressionPtr& operand : expression.operands) write(*operand);
  out_.close(name);
}

void XmlExpressionWriter::negation(const Expression& expression) {
  const Expression& operand = *expression.operands.front();
  if (operand.kind == Expression::Kind::number)
    return out_.empty("decimal-value", {{"value", "-" + digits(operand.name)}});
  out_.open("minus", {});
  out_.empty("decimal-value", {{"value", "0"}});
  write(operand);
  out_.close("minus");
}

void XmlExpressionWriter::conditional(const Expression& expression) {
  out_.open("conditional-expression", {});
  constexpr const char* names[] = {"condition", "expression1", "expression2"};
  for (std::size_t i = 0; i < 3; ++i) {
    out_.open(names[i], {});
    write(*expression.operands[i]);
    out_.close(names[i]);
  }
  out_.close("conditional-expression");
}

bool XmlExpressionWriter::comparison(const Expression& expression) {
  const bool equal = expression.operation == Operator::equal;
  if (!equal && expression.operation != Operator::notEqual) return false;
  const Expression& left = *expression.operands[0];
  const bool named = left.kind == Expression::Kind::name ||
                     (left.kind == Expression::Kind::call && left.arguments.empty());
  const Symbol* const symbol = named ? find(inputs_, left.name) : nullptr;
  const Enumeration* enumeration = symbol ? enumerationOf(*symbol) : nullptr;
  if (!enumeration || !isElement(*enumeration, *expression.operands[1])) return false;
  if (!equal) out_.open("not", {});
  out_.empty("enumerated-input-symbol-comparison",
             {{"ref", std::string(symbol->name.text)},
              {"value", elementName(*symbol, *enumeration, expression.operands[1]->name)}});
  if (!equal) out_.close("not");
  return true;
}

void XmlExpressionWriter::writeValues(const char* element, const char* inner, std::string_view ref,
                                      const std::vector<Argument>& arguments) {
  const Attributes reference = {{"ref", std::string(ref)}};
  if (arguments.empty()) return out_.empty(element, reference);
  out_.open(element, reference);
  for (const Argument& argument : arguments) {
    const std::string prefix = std::string(ref) + ".";
    const std::string_view name = argument.name.text;
    const bool whole = name.substr(0, prefix.size()) == prefix;
    out_.open(inner, {{"ref", (whole ? "" : prefix) + std::string(name)}});
    write(*argument.value);
    out_.close(inner);
  }
  out_.close(element);
}

}  // namespace xabsl
