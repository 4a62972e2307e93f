#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "xabsl/Diagnostic.h"
#include "xabsl/Language.h"

/// The syntax tree: what stands in the sources, before names and types are resolved. Built by the
/// Parser, read by the Analyzer. All texts are views into the sources.
namespace xabsl::syntax {

struct Name {
  std::string_view text;
  Location location;
};

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;

/// `name = value` in the parentheses of a call.
struct Argument {
  Name name;
  ExpressionPtr value;
};

/// One operator, literal, or name with all that stands below it.
struct Expression {
  enum class Kind {
    number,
    boolean,
    name,
    parameter,
    call,
    stateTime,
    optionTime,
    actionDone,
    operation
  };

  Kind kind = Kind::number;
  Location location;
  std::string_view name;  // of a name, a parameter or a call
  double number = 0;      // of a number; 0 or 1 of a boolean
  Operator operation = Operator::constant;
  std::vector<ExpressionPtr> operands;
  std::vector<Argument> arguments;
  int depth = 1;  // levels from here down
};

struct TypeName {
  ValueKind kind = ValueKind::number;
  Name enumeration;
};

struct Parameter {
  Name name;
  TypeName type;
};

struct Enumeration {
  Name name;
  std::vector<Name> elements;
};

struct Symbol {
  SymbolKind kind = SymbolKind::input;
  Name name;
  TypeName type;
  std::vector<Parameter> parameters;
};

struct Constant {
  Name name;
  double value = 0;
};

struct Behavior {
  Name name;
  std::vector<Parameter> parameters;
};

struct Decision;
using DecisionPtr = std::unique_ptr<Decision>;

/// One `if (condition) decision` of a chain of `else if`.
struct Arm {
  ExpressionPtr condition;
  DecisionPtr decision;
};

/// A decision tree: goes to a state, stays, or asks the arms one after another.
struct Decision {
  enum class Kind { stay, go, choose };

  Kind kind = Kind::stay;
  Name target;
  std::vector<Arm> arms;
  DecisionPtr otherwise;  // none in a common decision tree
};

/// An assignment, or a call of an option or a basic behavior.
struct Action {
  enum class Kind { assignment, call, callOption, callBehavior };

  Kind kind = Kind::call;
  Name name;
  ExpressionPtr value;
  std::vector<Argument> arguments;
};

struct State {
  Name name;
  bool initial = false;
  bool target = false;
  bool leadingElse = false;
  Location decisionLocation;
  DecisionPtr decision;
  std::vector<Action> actions;
};

struct Option {
  Name name;
  std::vector<Parameter> parameters;
  DecisionPtr commonDecision;
  std::vector<Action> commonActions;
  std::vector<State> states;
};

struct Agent {
  Name name;
  Name rootOption;
};

/// All that was declared, in all files.
struct Program {
  std::vector<Enumeration> enumerations;
  std::vector<Symbol> symbols;
  std::vector<Constant> constants;
  std::vector<Behavior> behaviors;
  std::vector<Option> options;
  std::vector<Agent> agents;
};

}  // namespace xabsl::syntax
