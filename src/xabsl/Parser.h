#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/Lexer.h"
#include "xabsl/Reporter.h"
#include "xabsl/Syntax.h"

namespace xabsl {

/// A file that another one asks for.
struct Include {
  std::string_view path;
  Location location;
};

/// Reads one file of XABSL 3.1 text into the syntax tree. A syntax error is reported, and reading
/// goes on with the next action, state or declaration.
class Parser {
 public:
  /// Deeper nested expressions and decisions are refused.
  static constexpr int maximalNesting = 200;

  Parser(int file, std::string_view text, Reporter& reporter, syntax::Program& program);

  /// Appends to the program; returns what the file includes.
  std::vector<Include> parse();

 private:
  struct SyntaxError {};
  class Nesting;

  [[noreturn]] void fail(const std::string& message);
  [[noreturn]] void failExpected(const std::string& what);
  Token take();
  bool accept(std::string_view text);
  void expect(std::string_view text);
  syntax::Name expectName(const std::string& what);
  void warnFileName(const std::string& what, const syntax::Name& name);
  void skipToDeclaration();
  void skipToMember();
  void skipToState();
  void skipToNextAction();

  void declaration();
  void include();
  void agent();
  void namespaceBlock();
  void namespaceMember();
  void enumeration();
  void enumerationElements(syntax::Enumeration enumeration);
  void constant();
  void symbol(syntax::TypeName type);
  void behavior();
  bool typeName(syntax::TypeName& type);
  std::vector<syntax::Parameter> parameters(std::string_view close);
  syntax::Parameter parameter(bool ofOption);
  void unitAndRange();

  void option();
  void states(syntax::Option& option);
  bool atState() const;
  syntax::State state();
  void refuseCooperation();
  void stateBody(syntax::State& state);
  std::vector<syntax::Action> actions();
  syntax::Action action();
  std::vector<syntax::Argument> arguments();
  syntax::DecisionPtr commonDecision();
  syntax::DecisionPtr decision();
  syntax::DecisionPtr choice();
  syntax::DecisionPtr transition();

  syntax::ExpressionPtr condition();
  syntax::ExpressionPtr expression();
  syntax::ExpressionPtr disjunction();
  syntax::ExpressionPtr conjunction();
  syntax::ExpressionPtr comparison();
  syntax::ExpressionPtr sum();
  syntax::ExpressionPtr product();
  syntax::ExpressionPtr unary();
  syntax::ExpressionPtr primary();
  syntax::ExpressionPtr operation(Operator op, Location location,
                                  std::vector<syntax::ExpressionPtr> operands);
  syntax::ExpressionPtr binary(Operator op, Location location, syntax::ExpressionPtr left,
                               syntax::ExpressionPtr right);

  Reporter& reporter_;
  syntax::Program& program_;
  Lexer lexer_;
  Token token_;
  std::vector<Include> includes_;
  int nesting_ = 0;
};

}  // namespace xabsl
