#pragma once

#include <cstddef>

/// Definitions shared by syntax tree and model.
namespace xabsl {

/// Converts an index for the containers of the library. The index -1 means "none".
constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// The types of XABSL: float, bool and enum. All values are stored as numbers: 0 and 1 for false
/// and true.
enum class ValueKind { number, boolean, enumeration };

enum class SymbolKind { input, output, internal };

/// The keyword of the language.
constexpr const char* wordOf(SymbolKind kind) {
  return kind == SymbolKind::input ? "input" : kind == SymbolKind::output ? "output" : "internal";
}

/// The versions of the language. In 2.1 output symbols are set after the whole graph was executed
/// (report H.7), in 3.0 and 3.1 at once.
enum class Dialect { xabsl21, xabsl30, xabsl31 };

/// The cooperation of the robots that execute the same option in a state: at most `agents` of them
/// may be in the state (capacity), or at least that many enter it together (synchronized).
struct Cooperation {
  enum class Kind { none, capacity, synchronized };

  Kind kind = Kind::none;
  int agents = 0;
};

/// The operator of an expression, with the indices a, b and c of the resolved Expression.
enum class Operator {
  constant,   ///< number; a: its index if it has a name; b: 1 for true and false
  element,    ///< a: enumeration, b: element
  parameter,  ///< a: option, b: parameter of it
  input,      ///< a: symbol, b: first operand, one per parameter
  variable,   ///< a: output or internal symbol
  stateTime,
  optionTime,
  actionDone,
  conflict,    ///< in a cooperative state: too many others are in it
  negate,      ///< a
  logicalNot,  ///< a
  add,         ///< a, b: expressions, and so on
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
  logicalAnd,  ///< b: first operand, c: number of operands
  logicalOr,
  conditional  // a ? b : c
};

}  // namespace xabsl
