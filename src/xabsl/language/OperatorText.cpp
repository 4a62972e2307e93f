#include "xabsl/language/OperatorText.h"

namespace xabsl {

OperatorText textOf(Operator operation) {
  switch (operation) {
    case Operator::logicalOr:
      return {" || ", disjunction};
    case Operator::logicalAnd:
      return {" && ", conjunction};
    case Operator::equal:
      return {" == ", comparison};
    case Operator::notEqual:
      return {" != ", comparison};
    case Operator::less:
      return {" < ", comparison};
    case Operator::lessEqual:
      return {" <= ", comparison};
    case Operator::greater:
      return {" > ", comparison};
    case Operator::greaterEqual:
      return {" >= ", comparison};
    case Operator::add:
      return {" + ", sum};
    case Operator::subtract:
      return {" - ", sum};
    case Operator::multiply:
      return {" * ", product};
    case Operator::divide:
      return {" / ", product};
    case Operator::modulo:
      return {" % ", product};
    case Operator::negate:
      return {"-", sign};
    case Operator::logicalNot:
      return {"!", sign};
    case Operator::conditional:
      return {" ? ", lowest};
    default:
      return {"", primary};
  }
}

}  // namespace xabsl
