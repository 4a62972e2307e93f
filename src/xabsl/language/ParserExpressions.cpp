#include <algorithm>
#include <utility>

#include "xabsl/language/Parser.h"

/// The part of the parser for nested structures: decision trees and expressions.
namespace xabsl {

using namespace syntax;

/// Counts the nesting depth of the parser; fails if it exceeds the limit.
class Parser::Nesting {
 public:
  explicit Nesting(Parser& parser) : parser_(parser) {
    if (parser_.nesting_ >= maximalNesting)
      parser_.fail("nested too deeply, at most " + std::to_string(maximalNesting) + " levels");
    ++parser_.nesting_;
  }
  ~Nesting() { --parser_.nesting_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  Parser& parser_;
};

DecisionPtr Parser::commonDecision() {
  expect("{");
  common_ = true;
  DecisionPtr decision = commonChoice();
  common_ = false;
  expect("}");
  return decision;
}

/// `if ... else if ...` without a final `else`: the decision tree of the state follows. A decision
/// in braces behind `else` continues the same chain.
DecisionPtr Parser::commonChoice() {
  const Nesting nesting(*this);
  if (accept("{")) {
    DecisionPtr inner = commonChoice();
    expect("}");
    return inner;
  }
  if (!token_.is("if")) failExpected("'if'");
  auto [choice, open] = arms();
  if (open && token_.is("{")) {
    DecisionPtr rest = commonChoice();
    for (Arm& next : rest->arms) choice->arms.push_back(std::move(next));
  } else if (open) {
    decision();
    reporter_.error(token_.location, "a common decision ends without an 'else'");
  }
  choice->extent.end = end_;
  return std::move(choice);
}

/// A chain of `else if` may be long: it is read in a loop, never by recursion.
std::pair<DecisionPtr, bool> Parser::arms() {
  auto choice = std::make_unique<Decision>();
  choice->kind = Decision::Kind::choose;
  choice->extent.begin = token_.location;
  std::string_view doc = documentation(token_);
  for (;;) {
    choice->arms.push_back(arm(doc));
    choice->extent.end = end_;
    if (!token_.is("else")) return {std::move(choice), false};
    const Token sign = take();
    if (!token_.is("if")) return {std::move(choice), true};
    doc = documentation(token_.doc.empty() ? sign : token_);
  }
}

Arm Parser::arm(std::string_view doc) {
  Arm arm;
  take();
  arm.doc = doc;
  arm.condition = condition();
  arm.decision = decision();
  return arm;
}

DecisionPtr Parser::decision() {
  const Nesting nesting(*this);
  if (accept("{")) {
    DecisionPtr inner = decision();
    expect("}");
    return inner;
  }
  if (!token_.is("if")) return transition();
  auto [choice, open] = arms();
  if (!open) failExpected("'else', since each decision has an end ('else stay;')");
  choice->otherwise = decision();
  choice->extent.end = end_;
  return std::move(choice);
}

DecisionPtr Parser::transition() {
  auto transition = std::make_unique<Decision>();
  transition->extent.begin = token_.location;
  if (accept("goto")) {
    transition->kind = Decision::Kind::go;
    transition->target = expectName("the name of a state");
  } else if (accept("stay")) {
    if (common_) warnOfDialect(transition->extent.begin, "'stay' in a common decision");
  } else {
    failExpected("'if', 'goto', 'stay' or '{'");
  }
  expectSemicolon();
  transition->extent.end = end_;
  return transition;
}

ExpressionPtr Parser::condition() {
  expect("(");
  ExpressionPtr condition = expression();
  expect(")");
  return condition;
}

ExpressionPtr Parser::expression() {
  const Nesting nesting(*this);
  ExpressionPtr condition = binary(Level::disjunction);
  if (!token_.is("?")) return condition;
  const Location location = take().location;
  std::vector<ExpressionPtr> operands;
  operands.push_back(std::move(condition));
  operands.push_back(expression());
  expect(":");
  operands.push_back(binary(Level::disjunction));
  if (token_.is("?")) fail("a '?:' inside another one needs parentheses");
  return operation(Operator::conditional, location, std::move(operands));
}

/// The operator of a level if the next token is one, or null.
const OperatorSpelling* Parser::operatorOf(Level level) const {
  return findOperator(
      [&](const OperatorSpelling& one) { return one.level == level && token_.is(one.text); });
}

/// Reads operators of a level between operands of higher levels. `&&` and `||` have any number of
/// operands; all others are left-associative.
ExpressionPtr Parser::binary(Level level) {
  if (level == Level::sign) return unary();
  const Level tighter = static_cast<Level>(level + 1);
  ExpressionPtr left = binary(tighter);
  while (const OperatorSpelling* found = operatorOf(level)) {
    const Location location = take().location;
    std::vector<ExpressionPtr> operands;
    operands.push_back(std::move(left));
    operands.push_back(binary(tighter));
    while (level <= Level::conjunction && accept(found->text)) operands.push_back(binary(tighter));
    if (level == Level::comparison && operatorOf(level))
      fail("comparisons cannot be chained, use '&&'");
    left = operation(found->operation, location, std::move(operands));
  }
  return left;
}

ExpressionPtr Parser::unary() {
  const Nesting nesting(*this);
  if (!token_.is("!") && !token_.is("-")) return primary();
  const Token sign = take();
  std::vector<ExpressionPtr> operands;
  operands.push_back(unary());
  return operation(sign.is("!") ? Operator::logicalNot : Operator::negate, sign.location,
                   std::move(operands));
}

ExpressionPtr Parser::primary() {
  if (accept("(")) {
    ExpressionPtr inner = expression();
    expect(")");
    return inner;
  }

  using Kind = Expression::Kind;
  auto primary = std::make_unique<Expression>();
  primary->location = token_.location;
  primary->name = token_.text;
  primary->number = token_.number;
  if (token_.kind == TokenKind::number) {
    warnOfExponent();
    primary->kind = Kind::number;
  } else if (token_.kind == TokenKind::identifier) {
    primary->kind = Kind::name;
  } else if (token_.kind == TokenKind::parameter) {
    primary->kind = Kind::parameter;
  } else if (token_.is("true") || token_.is("false")) {
    primary->kind = Kind::boolean;
    primary->number = token_.is("true") ? 1 : 0;
  } else if (token_.is("state_time")) {
    primary->kind = Kind::stateTime;
  } else if (token_.is("option_time")) {
    primary->kind = Kind::optionTime;
  } else if (token_.is("action_done")) {
    primary->kind = Kind::actionDone;
  } else if (token_.is("conflict")) {
    primary->kind = Kind::conflict;
  } else {
    failExpected("an expression");
  }
  take();
  if (primary->kind == Kind::name && token_.is("(")) {
    primary->kind = Kind::call;
    primary->arguments = arguments();
    for (const Argument& argument : primary->arguments)
      primary->depth = std::max(primary->depth, argument.value->depth + 1);
  }
  primary->extent = {primary->location, end_};
  return primary;
}

ExpressionPtr Parser::operation(Operator op, Location location,
                                std::vector<ExpressionPtr> operands) {
  auto node = std::make_unique<Expression>();
  node->kind = Expression::Kind::operation;
  node->operation = op;
  node->location = location;
  node->operands = std::move(operands);
  const Location first = node->operands.front()->extent.begin;
  // A sign stands before its operand, all other operators behind their first one.
  const bool prefix = op == Operator::negate || op == Operator::logicalNot;
  node->extent = {prefix ? location : first, end_};
  for (const ExpressionPtr& operand : node->operands)
    node->depth = std::max(node->depth, operand->depth + 1);
  // A long sum nests as deep as it is long, without any parentheses.
  if (node->depth > maximalNesting)
    fail("expression is too long, at most " + std::to_string(maximalNesting) + " levels");
  return node;
}

}  // namespace xabsl
