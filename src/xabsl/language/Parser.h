#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xabsl/language/Lexer.h"
#include "xabsl/language/Operators.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// Reads one file of XABSL text into the syntax tree. A syntax error is reported, and parsing
/// continues with the next action, state, symbol or declaration. Broken declarations are kept as
/// far as they were read, for editors; options, states and namespaces also without a name.
class Parser {
 public:
  /// Greatest nesting depth of expressions and decisions.
  static constexpr int maximalNesting = 200;

  /// `program.dialect` selects XABSL 3.0 or 3.1.
  Parser(int file, std::string_view text, Reporter& reporter, syntax::Program& program);

  /// Parses the file and appends its declarations to the program. Its includes and comments are
  /// added to its syntax::File, which must exist.
  void parse();

 private:
  struct SyntaxError {};
  enum class Block { none, option, space };
  class Nesting;

  [[noreturn]] void fail(const std::string& message);
  [[noreturn]] void failAt(Location location, const std::string& message);
  [[noreturn]] void failExpected(const std::string& what);
  void warnOfExponent();
  void warnOfDialect(Location location, const std::string& what);
  Token take();
  bool accept(std::string_view text);
  void expect(std::string_view text);
  void expectSemicolon();
  syntax::Name expectName(const std::string& what);
  void warnFileName(const std::string& what, const syntax::Name& name);
  syntax::Declaration begin();
  std::string_view documentation(const Token& token);
  bool atDeclaration() const;
  bool atSymbol() const;
  bool atType() const;
  bool atParameter() const;
  bool atCommonOrState() const;
  bool atState() const;
  void recover();
  void guess(bool space);
  void enter(Block block);
  void skipToDeclaration();
  void skipToMember();
  void skipToNextParameter();
  void skipToState();
  void skipToActions();
  void skipToNextAction();

  /// Reads the rest of a declaration that has a name, and keeps the declaration even if the rest is
  /// broken.
  template <typename Kept, typename Rest>
  void finish(std::vector<Kept>& list, Kept& declaration, Rest rest) {
    const auto keep = [&] {
      declaration.extent.end = end_;
      list.push_back(std::move(declaration));
    };
    try {
      rest();
    } catch (const SyntaxError&) {
      keep();
      throw;
    }
    keep();
  }

  void declaration();
  void include();
  void agent();
  void namespaceBlock();
  void namespaceBody();
  void namespaceMembers();
  void namespaceMember();
  void enumeration();
  void enumerationElements(const syntax::Declaration& declaration, const syntax::Name& name,
                           bool internal);
  void constant(const syntax::Declaration& declaration);
  void symbol(const syntax::Declaration& declaration, const syntax::TypeName& type);
  void enterNamespace(syntax::Namespace::Kind kind, Location location);
  void header();
  void behavior();
  bool typeName(syntax::TypeName& type);
  void parameters(std::vector<syntax::Parameter>& parameters, std::string_view close);
  syntax::Parameter parameter(bool ofOption);
  void unitAndRange(std::string_view& range, std::string_view& unit);

  void option();
  void optionBody();
  void common(syntax::Option& option);
  void states(syntax::Option& option);
  void state(syntax::State& state);
  Cooperation cooperation();
  void stateBody(syntax::State& state);
  void actions(std::vector<syntax::Action>& actions);
  syntax::Action action();
  std::vector<syntax::Argument> arguments();
  syntax::DecisionPtr commonDecision();
  syntax::DecisionPtr commonChoice();
  /// Reads the arms of `if ... else if ...`. The second result is whether an `else` without `if`
  /// follows.
  std::pair<syntax::DecisionPtr, bool> arms();
  syntax::DecisionPtr decision();
  syntax::Arm arm(std::string_view doc);
  syntax::DecisionPtr transition();

  syntax::ExpressionPtr condition();
  syntax::ExpressionPtr expression();
  const OperatorSpelling* operatorOf(Level level) const;
  syntax::ExpressionPtr binary(Level level);
  syntax::ExpressionPtr unary();
  syntax::ExpressionPtr primary();
  syntax::ExpressionPtr operation(Operator op, Location location,
                                  std::vector<syntax::ExpressionPtr> operands);

  Reporter& reporter_;
  syntax::Program& program_;
  Lexer lexer_;
  Token token_;
  Location end_;  ///< of the last token taken
  int file_;
  int space_ = -1;  ///< the namespace that is being read
  int nesting_ = 0;
  Block block_ = Block::none;  ///< the block that is being read, or was read last
  bool closed_ = false;        ///< whether the block's closing brace was read
  bool common_ = false;        ///< whether it is within a common decision
  /// whether it reads parts without an option or namespace; errors are silent
  bool guesses_ = false;
  bool hasNamespace_ = false;
};

}  // namespace xabsl
