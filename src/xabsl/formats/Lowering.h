#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xabsl/language/Model.h"

/// What the public compilers make of expressions, in intermediate code and in XML alike.
namespace xabsl {

/// Whole numbers without a point, all others with as many digits as they need.
std::string decimalText(double number);

/// The value of a number with signs before it, or nothing: then a sign is a subtraction from 0.
std::optional<double> signedNumber(const Model& model, const Expression& negation);

/// The operands of `&&` or `||` together with those of the same operator below it.
std::vector<int> flattened(const Model& model, int connection);

/// Whether an expression is of an enumeration: such ones are compared otherwise than numbers.
bool isEnumerated(const Model& model, int expression);

}  // namespace xabsl
