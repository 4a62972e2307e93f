#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xabsl/formats/intermediate/EnumerationInference.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

struct RegisteredFunction;
class Symbols;

/// Reads intermediate code of one dialect into a model. Stops at the first error.
class IntermediateCodeReader {
 public:
  IntermediateCodeReader(std::string_view text, Dialect dialect, const Symbols* registered,
                         Reporter& reporter);

  /// Returns the model, which is valid only if the reporter has not failed.
  Model read();

  /// The place of the present token.
  Location location() const { return token_.location; }

 private:
  struct Failed {};

  struct Token {
    std::string_view text;  ///< empty: the end of the file
    Location location;
  };

  /// A call. Its operands are laid out at the end, when all parameters are known.
  struct Call {
    Action::Kind kind;  ///< assignment: of an input symbol
    int target;
    int caller;  ///< the action, or the expression of an input symbol
    std::vector<std::pair<int, int>> arguments;  ///< parameter, expression
  };

  /// An expression of an enumeration type, with the domain of the enumeration.
  struct Element {
    int expression;
    int domain;
  };

  [[noreturn]] void fail(const Token& token, const std::string& message);
  [[noreturn]] void failExpected(const std::string& what);
  Token take();
  void skipBlanks();
  std::string name(const std::string& what);
  std::size_t count(const std::string& what);
  double number();
  ValueKind kind();

  void internalEnumerations();
  void internalSymbols();
  void declareOptions();
  void defineOption(Option& option);
  void listStates(Option& option);
  Cooperation cooperation();
  void defineState(int index);
  int state(const Token& token);
  Branch statement(int depth);
  void agents();

  void action();
  void assignment(Action& action);
  Type typed();
  int symbol(std::map<std::string, int, std::less<>>& table, SymbolKind symbolKind,
             const Token& token, ValueKind kind);
  int behavior(const Token& token);
  void completeInput(Symbol& symbol);
  std::vector<Parameter> registeredParameters(const RegisteredFunction& function,
                                              const Token& token);
  std::vector<Parameter>& parametersOf(const Call& call);
  const std::string& nameOf(const Call& call);
  void arguments(Call call, int depth);
  int parameter(const Call& call, Type type, const Token& token);

  int expression(ValueKind kind, int depth);
  int decimal(int depth);
  int boolean(int depth);
  Element element(int depth);
  int optionParameter(ValueKind kind);
  int input(ValueKind kind, int depth);
  int variable(ValueKind kind);
  int operands(Operator operation, ValueKind kind, int operandCount, const Token& token, int depth);
  int connection(Operator operation, const Token& token, int depth);
  int comparison(const Token& token, int depth);
  int constant(const Token& token);
  int add(const Expression& expression, const Token& token);
  void unite(int a, int b, const Token& token);
  void checkDepth(int depth);

  void finish();
  void resolveTypes();
  void resolveExpressions(int offset);
  void layOutOperands(int offset);

  std::string_view text_;
  Dialect dialect_;
  const Symbols* registered_;
  Reporter& reporter_;
  EnumerationInference enumerations_;
  Model model_;
  std::size_t position_ = 0;
  Location location_;
  Token token_;
  int option_ = -1;  ///< the option that is being read
  std::map<std::string, int, std::less<>> inputs_;
  std::map<std::string, int, std::less<>> variables_;
  std::map<std::string, int, std::less<>> behaviors_;
  std::map<std::string, int, std::less<>> options_;
  std::map<std::string, int, std::less<>> states_;
  std::map<std::string, int, std::less<>> constants_;
  std::vector<Call> calls_;
};

}  // namespace xabsl
