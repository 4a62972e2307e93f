#include "xabsl/tools/testing/TestFile.h"

#include <limits>
#include <utility>

#include "xabsl/language/Lexer.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

namespace {

/// Reads a file statement by statement; continues behind the semicolon of a wrong one.
class TestParser {
 public:
  TestParser(TestFile& file, std::string_view text, Reporter& reporter)
      : file_(file),
        reporter_(reporter),
        lexer_(reporter.addFile(file.path, text), text, reporter) {
    token_ = lexer_.next();
  }

  void parse() {
    while (!atEnd() && !reporter_.full()) {
      try {
        item();
      } catch (const SyntaxError&) {
        skipStatement();
      }
    }
    if (file_.behavior.text.empty() && !reporter_.failed())
      reporter_.error({}, "expected 'behavior \"PATH\";'");
  }

 private:
  struct SyntaxError {};
  using Kind = TestStatement::Kind;

  [[noreturn]] void failExpected(const std::string& what) {
    reporter_.error(token_.location, "expected " + what + ", found " + describe(token_));
    throw SyntaxError();
  }

  bool atEnd() const { return token_.kind == TokenKind::end; }
  bool is(std::string_view text) const {
    return token_.text == text && token_.kind != TokenKind::string && !atEnd();
  }
  Token take() { return std::exchange(token_, lexer_.next()); }
  bool accept(std::string_view text) {
    if (!is(text)) return false;
    take();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) failExpected(inQuotes(text));
  }
  TestText name(const char* what) {
    if (token_.kind != TokenKind::identifier) failExpected(what);
    const Token token = take();
    return {token.text, token.location};
  }
  TestText quoted(const char* what) {
    if (token_.kind != TokenKind::string) failExpected(what);
    const Token token = take();
    return {token.text, token.location};
  }
  double milliseconds() {
    if (token_.kind != TokenKind::number) failExpected("a time in ms");
    return take().number;
  }

  /// All up to a semicolon or one of these words; what it means is seen when it is compiled.
  TestText expression(std::string_view end = {}, std::string_view otherEnd = {}) {
    TestText text{token_.text, token_.location};
    int parentheses = 0;
    const char* last = nullptr;
    while (!atEnd() && !is(";") && !is("}")) {
      if (parentheses == 0 && (is(end) || is(otherEnd) || (is(")") && otherEnd == ")"))) break;
      if (is("(")) ++parentheses;
      if (is(")")) --parentheses;
      if (token_.kind == TokenKind::string || token_.kind == TokenKind::range ||
          token_.kind == TokenKind::parameter)
        failExpected("an expression");
      last = token_.text.data() + token_.text.size();
      take();
    }
    if (!last) failExpected("an expression");
    text.text = {text.text.data(), static_cast<std::size_t>(last - text.text.data())};
    return text;
  }

  void item() {
    if (is("test")) return test();
    if (accept("behavior")) {
      file_.behavior = quoted("the path of a behavior in quotes");
      return expect(";");
    }
    if (!file_.tests.empty()) failExpected("'test'");
    file_.common.push_back(statement());
  }

  void test() {
    BehaviorTest test;
    test.location = take().location;
    test.name = quoted("the name of a test in quotes").text;
    expect("{");
    while (!atEnd() && !is("}")) {
      try {
        test.statements.push_back(statement());
      } catch (const SyntaxError&) {
        skipStatement();
      }
    }
    file_.tests.push_back(std::move(test));
    expect("}");
  }

  void skipStatement() {
    while (!atEnd() && !is(";") && !is("}")) take();
    accept(";");
  }

  TestStatement statement() {
    TestStatement statement;
    statement.location = token_.location;
    if (accept("step")) {
      statement.kind = Kind::step;
      statement.time = milliseconds();
      if (!(statement.time >= 1)) failExpected("a step of at least 1 ms before");
    } else if (accept("agent")) {
      statement.kind = Kind::agent;
      statement.name = name("the name of an agent");
    } else if (accept("option")) {
      option(statement);
    } else if (accept("function")) {
      function(statement);
    } else if (accept("run")) {
      statement.kind = Kind::run;
      if (!is(";") && !is("while")) statement.time = milliseconds();
      condition(statement);
    } else if (accept("until")) {
      statement.kind = Kind::until;
      statement.expression = expression("within");
      expect("within");
      statement.time = milliseconds();
    } else if (accept("expect")) {
      statement.kind = Kind::expect;
      statement.expression = expression();
    } else if (accept("replay")) {
      replay(statement);
    } else {
      statement.kind = Kind::input;
      statement.name = name("a statement");
      expect("=");
      statement.expression = expression();
    }
    expect(";");
    return statement;
  }

  void condition(TestStatement& statement) {
    if (accept("while")) statement.expression = expression();
  }

  void replay(TestStatement& statement) {
    statement.kind = Kind::replay;
    statement.name = quoted("the path of a trace in quotes");
    statement.time = accept("from") ? milliseconds() : -std::numeric_limits<double>::infinity();
    statement.to = accept("to") ? milliseconds() : std::numeric_limits<double>::infinity();
    condition(statement);
  }

  void option(TestStatement& statement) {
    statement.kind = Kind::option;
    statement.name = name("the name of an option or a basic behavior");
    if (!accept("(")) return;
    while (!is(")")) {
      statement.arguments.push_back(name("the name of a parameter"));
      expect("=");
      statement.values.push_back(expression(",", ")"));
      if (!accept(",")) break;
    }
    expect(")");
  }

  void function(TestStatement& statement) {
    statement.kind = Kind::function;
    statement.name = name("the name of an input symbol");
    expect("(");
    do {
      statement.arguments.push_back(name("the name of a parameter"));
    } while (accept(","));
    expect(")");
    expect("=");
    statement.expression = expression();
  }

  TestFile& file_;
  Reporter& reporter_;
  Lexer lexer_;
  Token token_;
};

}  // namespace

TestFile parseTests(const std::string& path, std::string_view text,
                    std::vector<Diagnostic>& diagnostics) {
  TestFile file;
  file.path = path;
  Reporter reporter;
  TestParser(file, text, reporter).parse();
  diagnostics = reporter.take();
  return file;
}

}  // namespace xabsl
