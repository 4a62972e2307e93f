#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "xabsl/engine/Function.h"
#include "xabsl/engine/Linker.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// The operation of an instruction. Its operands are *a and *b; `to` is the index of its result in
/// the engine's memory, or the instruction to jump to.
enum class Operation : std::uint8_t {
  // Values
  copy,
  one,
  zero,
  negate,
  add,
  subtract,
  multiply,
  divide,  ///< `to`: the index of the expression
  modulo,  ///< `to`: the index of the expression
  readSingle,
  readBoolean,
  readByte,
  readInteger,
  call,  ///< the function; a: its arguments
  stateTime,
  optionTime,
  actionDone,
  conflict,
  // Jumps
  jump,
  ifTrue,
  ifFalse,
  ifLess,
  ifNotLess,
  ifLessEqual,
  ifNotLessEqual,
  ifEqual,
  ifNotEqual,
  // The end of a decision; `to`: the actions
  stay,
  change,          ///< index: the state
  changeIfAgreed,  ///< index: the cooperative state
  // Jumps to the active state's part of the code
  decideInState,
  actInState,
  // Actions
  keepParameters,   ///< a: the first one; index: their number
  markOption,       ///< for the cooperation of the team
  set,              ///< index: the symbol, which has its new value
  pass,             ///< stores *a as a parameter in `to`, and records whether it changed
  notifyOfChanges,  ///< index: the basic behavior
  callBehavior,     ///< index
  callOption,       ///< index
  back,
  // Additional events for a recorder
  recordOption,     ///< the option begins to decide
  recordRead,       ///< index: the expression; *a
  recordArgument,   ///< index: the parameter; *a
  recordHolds,      ///< index: the decision
  recordHoldsNot,   ///< index: the decision
  recordState,      ///< the option has decided
  recordBehavior,   ///< index
  recordAssignment  // index: the symbol; *a
};

struct Instruction {
  Operation operation;
  int to = 0;
  const double* a = nullptr;
  union {
    const double* b = nullptr;
    const void* variable;
    const Function* function;
    int index;
  };
};

/// A behavior as a list of instructions that an engine executes without looking anything up. The
/// first instruction is the `back` to which the root option returns.
struct Program {
  /// The beginnings of the code for an active state. The option's common decision and common
  /// actions come first, if there are any.
  struct StateCode {
    int decide = 0;
    int decideInState = 0;
    int act = 0;
    int actInState = 0;
  };

  std::vector<Instruction> code;
  std::vector<StateCode> states;
};

/// The places of all values in an engine's memory. First comes a place for each expression of the
/// model, which holds the constant or the result, so that expressions cannot overwrite each other.
struct MemoryLayout {
  std::vector<int> optionParameters;    ///< per option: its first parameter
  std::vector<int> behaviorParameters;  ///< per basic behavior: the first argument of its function
  std::vector<int> arguments;           ///< per expression that is a call: its first argument
  int variables = 0;                    ///< per symbol: the last value of an output or internal one
  std::size_t size = 0;

  explicit MemoryLayout(const Model& model);
};

/// Compiles a behavior for an engine with these bindings and this memory, neither of which may
/// move.
Program makeProgram(const Model& model, const Bindings& bindings, const MemoryLayout& layout,
                    const double* memory, bool recorded);

}  // namespace xabsl
