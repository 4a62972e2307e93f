#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Language.h"

/// The syntax tree of the sources. Built by the Parser; the Analyzer adds the resolved names; read
/// by writers and by editors. All texts are views into the sources, or into the pool of the
/// Program.
namespace xabsl::syntax {

/// From the first character of an element to behind its last one.
struct Extent {
  Location begin;
  Location end;
};

/// A comment with its place and marks (`//`, `/*`), for tools that rewrite sources.
struct Comment {
  enum class Kind { line, block, documentation, header };

  Kind kind = Kind::line;
  std::string_view text;
  Extent extent;
  bool documents = false;  ///< whether it documents a declaration or a condition
};

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

/// One operator, literal, or name with its subtree.
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
    conflict,
    operation
  };

  Kind kind = Kind::number;
  Location location;      ///< of an operation: place of its sign
  Extent extent;          ///< without parentheses around it
  std::string_view name;  ///< of a name, a parameter or a call; the digits of a number
  double number = 0;      ///< of a number; 0 or 1 of a boolean
  Operator operation = Operator::constant;
  std::vector<ExpressionPtr> operands;
  std::vector<Argument> arguments;
  int depth = 1;      ///< levels from here down
  int resolved = -1;  ///< by the Analyzer: index into Model::expressions
};

struct TypeName {
  ValueKind kind = ValueKind::number;
  Name enumeration;
};

/// Common part of all declarations. `doc` is the text of the documentation comment, without the
/// marks.
struct Declaration {
  Name name;
  std::string_view doc;
  Extent extent;
  int space = -1;  ///< index into Program::namespaces; -1: in none
};

struct Parameter : Declaration {
  TypeName type;
  std::string_view range;  ///< without the brackets
  std::string_view unit;   ///< without the quotes
};

struct Enumeration : Declaration {
  bool internal = false;  ///< not registered by the C++ program
  std::vector<Name> elements;
};

struct Symbol : Declaration {
  SymbolKind kind = SymbolKind::input;
  TypeName type;
  std::string_view range;
  std::string_view unit;
  std::vector<Parameter> parameters;
};

struct Constant : Declaration {
  double value = 0;
  bool negative = false;
  std::string_view digits;  ///< of the value, as written, without the sign
  std::string_view range;
  std::string_view unit;
};

struct Behavior : Declaration {
  std::vector<Parameter> parameters;
};

/// A group of symbols or of basic behaviors (report F.2, F.3).
struct Namespace : Declaration {
  enum class Kind { empty, symbols, behaviors };

  Kind kind = Kind::empty;
  std::string_view title;
};

struct Decision;
using DecisionPtr = std::unique_ptr<Decision>;

/// One `if (condition) decision` of a chain of `else if`.
struct Arm {
  std::string_view doc;
  ExpressionPtr condition;
  DecisionPtr decision;
};

/// A decision tree: goes to a state, stays, or evaluates the arms one after another.
struct Decision {
  enum class Kind { stay, go, choose };

  Kind kind = Kind::stay;
  Extent extent;
  Name target;
  std::vector<Arm> arms;
  DecisionPtr otherwise;  ///< none in a common decision tree
};

/// An assignment, or a call of an option or a basic behavior.
struct Action {
  enum class Kind { assignment, call, callOption, callBehavior };

  Kind kind = Kind::call;
  Name name;
  Extent extent;
  ExpressionPtr value;
  std::vector<Argument> arguments;
  int resolved = -1;  ///< by the Analyzer: index into Model::actions
};

struct State : Declaration {
  bool initial = false;
  bool target = false;
  Cooperation cooperation;
  bool leadingElse = false;
  Location decisionLocation;
  DecisionPtr decision;  ///< none: the state is never left by itself
  std::vector<Action> actions;
};

struct Option : Declaration {
  std::vector<Parameter> parameters;
  DecisionPtr commonDecision;
  bool hasCommonActions = false;
  std::vector<Action> commonActions;
  std::vector<State> states;
};

struct Agent : Declaration {
  std::string_view title;
  Name rootOption;
};

/// `include "path";`
struct Include {
  std::string_view path;  ///< as written, relative to the including file
  Location location;
};

/// One source with its includes, in their order. Its declarations have its index in their
/// locations.
struct File {
  std::string path;
  std::string_view text;
  std::vector<Include> includes;
  std::vector<Comment> comments;
};

/// `/*** Title: ... Platform: ... Software-Environment: ... */` of the file with the agents.
struct Header {
  std::string_view title;
  std::string_view platform;
  std::string_view softwareEnvironment;
};

/// All declarations of all files.
struct Program {
  Dialect dialect = Dialect::xabsl31;
  Header header;
  std::vector<File> files;  ///< in the order in which they were read, by Location::file
  std::vector<Namespace> namespaces;
  std::vector<Enumeration> enumerations;
  std::vector<Symbol> symbols;
  std::vector<Constant> constants;
  std::vector<Behavior> behaviors;
  std::vector<Option> options;
  std::vector<Agent> agents;
  std::deque<std::string> pool;

  /// Stores a text that is in no source for the lifetime of the program.
  std::string_view keep(std::string text) { return pool.emplace_back(std::move(text)); }
};

}  // namespace xabsl::syntax
