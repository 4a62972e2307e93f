#pragma once

/// The words that syntax tree and model share.
namespace xabsl {

/// The types of XABSL: float, bool and enum. All values are held as numbers: 0 and 1 for false and
/// true.
enum class ValueKind { number, boolean, enumeration };

enum class SymbolKind { input, output, internal };

/// What an expression does, with the indices a, b and c of the resolved Expression.
enum class Operator {
  constant,   // number
  element,    // a: enumeration, b: element
  parameter,  // a: option, b: parameter of it
  input,      // a: symbol, b: first operand, one per parameter
  variable,   // a: output or internal symbol
  stateTime,
  optionTime,
  actionDone,
  negate,      // a
  logicalNot,  // a
  add,         // a, b: expressions, and so on
  subtract,
  multiply,
  divide,
  modulo,
  equal,
  notEqual,
  less,
  lessEqual,
  greater,
  greaterEqual,
  logicalAnd,  // b: first operand, c: number of operands
  logicalOr,
  conditional  // a ? b : c
};

}  // namespace xabsl
