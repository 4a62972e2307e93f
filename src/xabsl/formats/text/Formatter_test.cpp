#include "xabsl/formats/text/Formatter.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <vector>

#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/tests/RandomBehavior.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

std::string formatted(const std::string& text) {
  Reporter reporter;
  return format(reporter.addFile("a.xabsl", text), text, reporter).value_or("nothing");
}

TEST(Formatter, IndentsAndKeepsCommentsAndGroups) {
  const std::string expected =
      "// what\n\n/** Plays. */\noption play {\n  initial state a {\n    decision {\n"
      "      if (x > 1) // far\n        goto a;\n      else stay;\n    }\n  }\n}\n";
  EXPECT_EQ(formatted("  // what\r\n\n\n\n/** Plays. */\noption  play {\ninitial\tstate a {\n"
                      "decision {  \nif (x > 1)  // far\ngoto a;\nelse stay;\n}\n}\n      }"),
            expected);
  EXPECT_EQ(formatted(expected), expected);
}

TEST(Formatter, RefusesBracketsThatAreNestedTooDeeply) {
  for (const std::string bracket : {"(", "(\n", "{", "{\n"}) {
    std::string text;
    for (int i = 0; i < 210; ++i) text += bracket;
    EXPECT_NE(formatted(text), "nothing");
    text += bracket;
    EXPECT_EQ(formatted(text), "nothing");
  }
  Reporter reporter;
  const std::string text(211, '(');
  format(reporter.addFile("a.xabsl", text), text, reporter);
  const std::vector<Diagnostic> diagnostics = reporter.take();
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "nested too deeply, at most 210 levels");
  EXPECT_EQ(diagnostics[0].column, 211);
}

TEST(Formatter, CountsNoBracketsInStringsAndComments) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "\"(\" /* { */ ";
  text.pop_back();
  EXPECT_EQ(formatted(text), text + '\n');
}

/// What takes a time that grows with the square of a line's length would not end.
TEST(Formatter, LongLinesTakeNoLonger) {
  std::string text;
  while (text.size() < 1'000'000) text += "a /**/ ";
  text.pop_back();
  EXPECT_EQ(formatted(text), text + '\n');
}

TEST(Formatter, KeepsStringsRangesAndParameters) {
  const std::string text = "float input a [0 ..  1] \"m  m\";\nx = @a;\n";
  EXPECT_EQ(formatted(text), text);
}

TEST(Formatter, KeepsTheLineEndsOfTheFile) {
  const std::string text =
      "/* what\r\n * it is */\r\noption play {\r\n  initial state a {\r\n  }\r\n}\r\n";
  EXPECT_EQ(formatted(text), text);
  EXPECT_EQ(formatted("/* what\r\n   it is */\noption play {\n}"),
            "/* what\n   it is */\noption play {\n}\n");
}

TEST(Formatter, MovesTheLinesOfACommentWithItsFirstOne) {
  EXPECT_EQ(formatted("option play {\n/* one\n   two\n\n * three */\ninitial state a {\n"
                      "        x(); /* four\n                five\nsix */\n}\n}"),
            "option play {\n  /* one\n     two\n\n   * three */\n  initial state a {\n"
            "    x(); /* four\n            five\nsix */\n  }\n}\n");
  EXPECT_EQ(
      formatted("option play {\n\t/**\n\t * one\n\t\ttwo\n\t */\n\tinitial state a {\n\t}\n}"),
      "option play {\n  /**\n   * one\n          two\n   */\n  initial state a {\n  }\n}\n");
}

TEST(Formatter, AlignsWhatStandsInParentheses) {
  const std::string text =
      "option play {\n  initial state a {\n    decision {\n      if (x > 1 &&\n          y < max(a "
      "= 1,\n"
      "                  b = 2)) goto a;\n      else stay;\n    }\n    action {\n      walk(\n     "
      "   x = 1,\n"
      "        y = 2\n      );\n    }\n  }\n}\n";
  EXPECT_EQ(formatted(text), text);
}

std::vector<std::string> tokensAndComments(const std::string& text) {
  Reporter reporter;
  std::vector<syntax::Comment> comments;
  std::vector<std::string> tokens;
  Lexer lexer(reporter.addFile("a.xabsl", text), text, reporter, &comments);
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
    tokens.emplace_back(token.text);
  // The lines of comments may move.
  for (const syntax::Comment& comment : comments)
    tokens.push_back(std::regex_replace(std::string(comment.text), std::regex("\\s*\n\\s*"), "\n"));
  return tokens;
}

TEST(Formatter, NeverChangesWhatTextMeansAndIsDoneAtOnce) {
  const std::vector<std::string> words{
      "option",   "play",   "{",           "}",        "(",    ")",    ";",
      ",",        "x",      "@y",          "=",        "==",   "12.5", "\"m s\"",
      "[0 .. 1]", "// c\n", "/* d\n e */", "/** f */", "goto", "&&",   "-"};
  const std::vector<std::string> gaps{" ", "  ", "\n", "\r\n", "\n\n\n", "\t"};
  std::mt19937 random{1};
  for (int i = 0; i < 500; ++i) {
    std::string text;
    for (int n = 0; n < 60; ++n)
      text += words[random() % words.size()] + gaps[random() % gaps.size()];
    const std::string once = formatted(text);
    ASSERT_EQ(tokensAndComments(once), tokensAndComments(text)) << text;
    ASSERT_EQ(formatted(once), once) << text;
  }
}

TEST(Formatter, LeavesBehaviorsAtRandomWhatTheyAre) {
  const auto code = [](const std::string& text) {
    return *writeIntermediateCode(test::compiled(text).model()).text;
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::string text = test::RandomBehavior(seed).write();
    const std::string once = formatted(text);
    EXPECT_EQ(code(once), code(text));
    EXPECT_EQ(formatted(once), once);
  }
}

TEST(Formatter, RefusesWhatIsNoToken) {
  EXPECT_EQ(formatted("option $"), "nothing");
  EXPECT_EQ(formatted("a /* b"), "nothing");
  EXPECT_EQ(formatted(""), "");
}

}  // namespace
}  // namespace xabsl
