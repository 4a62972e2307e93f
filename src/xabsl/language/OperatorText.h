#pragma once

#include "xabsl/language/Language.h"

namespace xabsl {

/// How tightly an operator binds; what binds less than its surroundings ask for needs parentheses.
enum Level { lowest, disjunction, conjunction, comparison, sum, product, sign, primary };

/// An operator as text; what is none binds most and has no text.
struct OperatorText {
  const char* text;
  Level level;
};

OperatorText textOf(Operator operation);

}  // namespace xabsl
