#pragma once

#include <string_view>

#include "xabsl/language/Language.h"

namespace xabsl::xml {

/// An operator and the element that stands for it (report F.8, F.9).
struct OperatorElement {
  std::string_view name;
  Operator operation;
};

constexpr OperatorElement operators[] = {{"and", Operator::logicalAnd},
                                         {"or", Operator::logicalOr},
                                         {"not", Operator::logicalNot},
                                         {"equal-to", Operator::equal},
                                         {"not-equal-to", Operator::notEqual},
                                         {"less-than", Operator::less},
                                         {"less-than-or-equal-to", Operator::lessEqual},
                                         {"greater-than", Operator::greater},
                                         {"greater-than-or-equal-to", Operator::greaterEqual},
                                         {"plus", Operator::add},
                                         {"minus", Operator::subtract},
                                         {"multiply", Operator::multiply},
                                         {"divide", Operator::divide},
                                         {"mod", Operator::modulo},
                                         {"conditional-expression", Operator::conditional}};

}  // namespace xabsl::xml
