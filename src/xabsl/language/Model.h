#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Language.h"

namespace xabsl {

/// A type of the language.
struct Type {
  ValueKind kind = ValueKind::number;
  int enumeration = -1;  ///< index into Model::enumerations

  bool operator==(const Type&) const = default;
};

struct EnumerationElement {
  std::string name;  ///< without the name of the enumeration
  Location location;
};

struct Enumeration {
  std::string name;
  std::vector<EnumerationElement> elements;
  Location location;
  bool internal = false;
  int space = -1;  ///< index into Model::namespaces; -1: in none
  std::string doc = {};
};

struct Parameter {
  std::string name;
  Type type;
  Location location;
  std::string range = {};
  std::string unit = {};
  std::string doc = {};
};

/// A group of symbols or of basic behaviors, for documentation.
struct Namespace {
  std::string name;
  std::string title;
  Location location;
  std::string doc = {};
};

/// A named number. Expressions hold its value; this entry is for writers and documentation.
struct Constant {
  std::string name;
  std::string digits;  ///< of the value, as written
  double value = 0;
  Location location;
  int space = -1;
  std::string unit = {};
  std::string doc = {};
};

/// The first use of a declaration.
struct Use {
  int option = -1;  ///< -1: nowhere
  Location location;
};

/// A value shared by the behavior and the C++ program; inputs with parameters are functions.
struct Symbol {
  SymbolKind kind = SymbolKind::input;
  std::string name;
  Type type;
  std::vector<Parameter> parameters;
  Location location;
  Use firstUse;
  int space = -1;
  std::string range = {};
  std::string unit = {};
  std::string doc = {};
};

/// The prototype of a basic behavior, which is written in C++.
struct BasicBehavior {
  std::string name;
  std::vector<Parameter> parameters;
  Location location;
  Use firstUse;
  int space = -1;
  std::string doc = {};
};

/// One operation. The meaning of the indices a, b and c is defined at Operator. A constant's a is
/// its index in Model::constants, or -1 for a literal number.
struct Expression {
  Operator operation = Operator::constant;
  int a = -1;
  int b = -1;
  int c = -1;
  double number = 0;
};

/// The result of a decision: a further decision, or the end of the decision tree.
struct Branch {
  enum class Kind {
    decision,
    state,
    stay,
    none
  };  ///< none: the common decision tree has not decided

  Kind kind = Kind::none;
  int index = -1;  ///< of the decision or the state
};

struct Decision {
  int condition = -1;  ///< index into Model::expressions
  Branch then;
  Branch otherwise;
  std::string doc = {};
};

struct Action {
  enum class Kind { option, behavior, assignment };

  Kind kind = Kind::option;
  int target = -1;   ///< index of the option, the basic behavior or the symbol
  int operand = -1;  ///< first of one operand per parameter, or the expression assigned
  Location location;
};

/// A range of a list that several owners share.
struct Span {
  int first = 0;
  int count = 0;

  /// Iterates over the indices of its elements in the list.
  struct Iterator {
    int index;

    int operator*() const { return index; }
    Iterator& operator++() {
      ++index;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Iterator begin() const { return {first}; }
  Iterator end() const { return {first + count}; }

  /// Its elements.
  template <typename Element>
  std::span<const Element> of(const std::vector<Element>& list) const {
    return std::span(list).subspan(at(first), at(count));
  }
};

struct State {
  std::string name;
  bool target = false;
  Branch decision;
  Span actions;
  Location location;
  Cooperation cooperation = {};
  std::string doc = {};
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
  std::string doc = {};
};

struct Agent {
  std::string name;
  int rootOption = -1;
  Location location;
  std::string title = {};
  std::string doc = {};
};

/// The index of the element with a name in a list, or -1.
template <typename List>
int indexOf(const List& list, std::string_view name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return static_cast<int>(i);
  return -1;
}

/// A whole behavior with all names and types resolved. Built by the compiler and immutable
/// afterwards; engines and tools read it.
struct Model {
  Dialect dialect = Dialect::xabsl31;
  std::string title;
  std::string platform;
  std::string softwareEnvironment;
  std::vector<std::string> files;
  std::vector<Namespace> namespaces;
  std::vector<Constant> constants;
  std::vector<Enumeration> enumerations;
  std::vector<Symbol> symbols;
  std::vector<BasicBehavior> behaviors;
  std::vector<Option> options;
  std::vector<State> states;
  std::vector<Action> actions;
  std::vector<Decision> decisions;
  std::vector<Expression> expressions;  ///< begins with the default of each type
  std::vector<Location> expressionLocations;
  std::vector<int> operands;
  /// Parallel to the operands of each call: the parameter that was set first, second, and so on; -1
  /// behind the last one. The others have their default.
  std::vector<int> argumentOrder;
  std::vector<Agent> agents;  ///< the first is selected when an engine starts

  /// The largest number of options and basic behaviors, together with their parameters, in one
  /// cycle.
  std::size_t largestActivation = 0;

  /// The expression for a parameter not given: 0, false or the first element.
  static int defaultExpression(Type type) { return type.enumeration + 1; }

  /// The parameters that a call sets, in the order in which it sets them. `first` is its first
  /// operand, `count` the number of all parameters.
  std::span<const int> setParameters(int first, std::size_t count) const {
    const auto order = std::span(argumentOrder).subspan(at(first), count);
    const auto end = std::find(order.begin(), order.end(), -1);
    return order.first(static_cast<std::size_t>(end - order.begin()));
  }

  /// The index of an input symbol by its name, or -1. An output symbol may have the same name.
  int findInput(std::string_view name) const { return findSymbol(name, true); }

  /// The index of an output or internal symbol by its name, or -1.
  int findOutput(std::string_view name) const { return findSymbol(name, false); }

 private:
  int findSymbol(std::string_view name, bool input) const {
    for (std::size_t i = 0; i < symbols.size(); ++i)
      if (symbols[i].name == name && (symbols[i].kind == SymbolKind::input) == input)
        return static_cast<int>(i);
    return -1;
  }
};

}  // namespace xabsl
