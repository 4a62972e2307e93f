#pragma once

#include <string_view>

#include "xabsl/language/Language.h"

namespace xabsl {

/// The precedence of an operator, lowest first. An expression with a lower level than its context
/// requires needs parentheses.
enum Level { lowest, disjunction, conjunction, comparison, sum, product, sign, primary };

/// The spelling of an operator.
struct OperatorSpelling {
  Operator operation;
  Level level;
  std::string_view text;
  std::string_view element;  ///< XML element (report F.8, F.9); empty: none
  std::string_view code;     ///< in intermediate code; empty: none
};

constexpr OperatorSpelling operatorSpellings[] = {
    {Operator::conditional, lowest, "?:", "conditional-expression", "q"},
    {Operator::logicalOr, disjunction, "||", "or", "|"},
    {Operator::logicalAnd, conjunction, "&&", "and", "&"},
    {Operator::equal, comparison, "==", "equal-to", "="},
    {Operator::notEqual, comparison, "!=", "not-equal-to", "n"},
    {Operator::less, comparison, "<", "less-than", "<"},
    {Operator::lessEqual, comparison, "<=", "less-than-or-equal-to", "l"},
    {Operator::greater, comparison, ">", "greater-than", ">"},
    {Operator::greaterEqual, comparison, ">=", "greater-than-or-equal-to", "g"},
    {Operator::add, sum, "+", "plus", "+"},
    {Operator::subtract, sum, "-", "minus", "-"},
    {Operator::multiply, product, "*", "multiply", "*"},
    {Operator::divide, product, "/", "divide", "d"},
    {Operator::modulo, product, "%", "mod", "%"},
    {Operator::negate, sign, "-", "", ""},
    {Operator::logicalNot, sign, "!", "not", "!"}};

/// The first operator for which a condition holds, or null.
template <typename Condition>
constexpr const OperatorSpelling* findOperator(Condition condition) {
  for (const OperatorSpelling& spelling : operatorSpellings)
    if (condition(spelling)) return &spelling;
  return nullptr;
}

/// The spelling of an operator; for other expressions one with the highest level and without text.
constexpr OperatorSpelling spellingOf(Operator operation) {
  const OperatorSpelling* found =
      findOperator([&](const OperatorSpelling& one) { return one.operation == operation; });
  return found ? *found : OperatorSpelling{operation, primary, "", "", ""};
}

}  // namespace xabsl
