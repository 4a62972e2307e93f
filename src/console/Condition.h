#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "console/Values.h"

namespace gt {

/// A condition about values of a running simulation (commands until, expect, test situation):
/// comparisons (< <= > >= == !=) of values by path, numbers, names and sums (+ - * /), abs(a),
/// min(a, b), max(a, b) and distance(red1, ball), joined by and, or, not and parentheses.
///
///     score.red >= 1 and distance(red4, ball) < 300
///     state == playing or red1.RobotPose.validity > 0.5
class Condition {
 public:
  /// Parses a condition. An error states the place in the text.
  static Result<Condition> parse(std::string_view text);

  /// Whether the condition holds now; an error if a value does not exist or has the wrong kind.
  Result<bool> holds(Console& console) const;

 private:
  friend class ConditionParser;
  friend class ConditionValues;

  enum class Operator {
    number,
    name,
    orElse,
    andAlso,
    no,
    less,
    lessOrEqual,
    greater,
    greaterOrEqual,
    equal,
    unequal,
    plus,
    minus,
    times,
    divide,
    negate,
    abs,
    min,
    max,
    distance
  };
  struct Node {
    Operator operation;
    int a = -1, b = -1;  ///< Operands, as indices.
    double number = 0;
    std::string text{};
  };

  std::vector<Node> nodes_;
  int root_ = -1;
};

}  // namespace gt
