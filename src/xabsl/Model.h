#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "xabsl/Diagnostic.h"
#include "xabsl/Language.h"

namespace xabsl {

/// A type of the language.
struct Type {
  ValueKind kind = ValueKind::number;
  int enumeration = -1;  // index into Model::enumerations

  bool operator==(const Type&) const = default;
};

struct EnumerationElement {
  std::string name;  // without the name of the enumeration
  Location location;
};

struct Enumeration {
  std::string name;
  std::vector<EnumerationElement> elements;
  Location location;
};

struct Parameter {
  std::string name;
  Type type;
  Location location;
};

/// Where something declared is used first.
struct Use {
  int option = -1;  // -1: nowhere
  Location location;
};

/// A value that behavior and surroundings share; inputs with parameters are functions.
struct Symbol {
  SymbolKind kind = SymbolKind::input;
  std::string name;
  Type type;
  std::vector<Parameter> parameters;
  Location location;
  Use firstUse;
};

/// The prototype of a basic behavior, which is written in C++.
struct BasicBehavior {
  std::string name;
  std::vector<Parameter> parameters;
  Location location;
  Use firstUse;
};

/// One operation; a, b and c are indices, what into is said at Operator.
struct Expression {
  Operator operation = Operator::constant;
  int a = -1;
  int b = -1;
  int c = -1;
  double number = 0;
};

/// Where a decision leads: to a further decision, or to its end.
struct Branch {
  enum class Kind {
    decision,
    state,
    stay,
    none
  };  // none: a common decision tree that decided nothing

  Kind kind = Kind::none;
  int index = -1;  // of the decision or the state
};

struct Decision {
  int condition = -1;  // index into Model::expressions
  Branch then;
  Branch otherwise;
};

struct Action {
  enum class Kind { option, behavior, assignment };

  Kind kind = Kind::option;
  int target = -1;   // index of the option, the basic behavior or the symbol
  int operand = -1;  // first of one operand per parameter, or the expression assigned
  Location location;
};

/// A part of a list that several owners share.
struct Span {
  int first = 0;
  int count = 0;
};

struct State {
  std::string name;
  bool target = false;
  Branch decision;
  Span actions;
  Location location;
};

/// A state machine that calls other options and basic behaviors (report 3.8.1.1).
struct Option {
  std::string name;
  std::vector<Parameter> parameters;
  int initialState = -1;
  Span states;
  Branch commonDecision;
  Span commonActions;
  Location location;
};

struct Agent {
  std::string name;
  int rootOption = -1;
  Location location;
};

/// A whole behavior with all names and types resolved. Built by the compiler, never changed after
/// that; engines and tools read it.
struct Model {
  std::vector<std::string> files;
  std::vector<Enumeration> enumerations;
  std::vector<Symbol> symbols;
  std::vector<BasicBehavior> behaviors;
  std::vector<Option> options;
  std::vector<State> states;
  std::vector<Action> actions;
  std::vector<Decision> decisions;
  std::vector<Expression> expressions;  // begins with the default of each type
  std::vector<Location> expressionLocations;
  std::vector<int> operands;
  std::vector<Agent> agents;  // the first is selected when an engine starts

  /// The largest number of options and basic behaviors, together with their parameters, in one
  /// cycle.
  std::size_t largestActivation = 0;

  /// The expression that stands for a parameter not given: 0, false or the first element.
  static int defaultExpression(Type type) { return type.enumeration + 1; }
};

}  // namespace xabsl
