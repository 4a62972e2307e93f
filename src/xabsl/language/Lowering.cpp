#include "xabsl/language/Lowering.h"

#include <charconv>
#include <cmath>

namespace xabsl {

std::string typedName(const Model& model, Type type, const std::string& name) {
  if (type.kind == ValueKind::number) return "d " + name;
  if (type.kind == ValueKind::boolean) return "b " + name;
  return "e " + model.enumerations[at(type.enumeration)].name + " " + name;
}

std::string decimalText(double number) {
  constexpr double largestWritten = 1e22;  // above that, a whole number is not exact anyway
  constexpr double smallestFixed = 1e-4;
  if (number == 0) return "0";  // also the negative zero
  char buffer[64];
  const bool whole = number == std::trunc(number) && std::fabs(number) < largestWritten;
  const bool fixed = whole || (std::fabs(number) >= smallestFixed && std::fabs(number) < 1e16);
  const auto format = fixed ? std::chars_format::fixed : std::chars_format::scientific;
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number, format).ptr);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos)
    text.insert(exponent, ".0");
  return text;
}

std::optional<double> signedNumber(const Model& model, const Expression& negation) {
  bool negative = true;
  const Expression* operand = &model.expressions[at(negation.a)];
  while (operand->operation == Operator::negate) {
    negative = !negative;
    operand = &model.expressions[at(operand->a)];
  }
  if (operand->operation != Operator::constant || operand->a >= 0) return std::nullopt;
  return negative ? -operand->number : operand->number;
}

std::vector<int> flattened(const Model& model, int connection) {
  const Operator operation = model.expressions[at(connection)].operation;
  std::vector<int> operands;
  std::vector<int> open = {connection};
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    const Expression& expression = model.expressions[at(index)];
    if (expression.operation != operation) {
      operands.push_back(index);
      continue;
    }
    for (int i = expression.c - 1; i >= 0; --i)
      open.push_back(model.operands[at(expression.b + i)]);
  }
  return operands;
}

}  // namespace xabsl
