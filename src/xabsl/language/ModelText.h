#pragma once

#include <string>
#include <vector>

#include "xabsl/language/Model.h"

namespace xabsl {

/// The type of an expression.
Type typeOf(const Model& model, int expression);

/// An expression of a model as XABSL text on one line, with the necessary parentheses only.
/// Elements are written without their enumeration if the other operand determines it.
std::string expressionText(const Model& model, int expression);

/// An action as XABSL text without the semicolon: `walk(x = @speed)`, `head.mode = look_at_ball`.
/// Parameters are written in the order in which they were set; those not set are left out.
std::string actionText(const Model& model, const Action& action);

/// A value as text: `1.5`, `true` or the name of the element with the value. `elements` has the
/// values of the elements of each enumeration.
std::string valueText(const Model& model, const std::vector<std::vector<double>>& elements,
                      Type type, double value);

/// The name of the option or basic behavior that an action calls, or of the symbol that it sets.
const std::string& targetName(const Model& model, const Action& action);

/// The parameters of the option or basic behavior that an action calls; empty for an assignment.
const std::vector<Parameter>& parametersOf(const Model& model, const Action& action);

}  // namespace xabsl
