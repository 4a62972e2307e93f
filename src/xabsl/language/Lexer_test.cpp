#include "xabsl/language/Lexer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using testing::ElementsAre;

std::vector<std::string> describedTokens(const std::string& text, Reporter& reporter) {
  Lexer lexer(reporter.addFile("f"), text, reporter);
  std::vector<std::string> words;
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
    words.push_back(describe(token));
  return words;
}

std::string lexicalErrors(const std::string& text) {
  Reporter reporter;
  describedTokens(text, reporter);
  return test::errors(reporter.take());
}

TEST(Lexer, SplitsTextIntoTokens) {
  Reporter reporter;
  EXPECT_THAT(describedTokens("if(ball.x>=12.5&&!@near)goto a_1;", reporter),
              ElementsAre("'if'", "'('", "'ball.x'", "'>='", "'12.5'", "'&&'", "'!'", "'@near'",
                          "')'", "'goto'", "'a_1'", "';'"));
  EXPECT_FALSE(reporter.failed());
}

/// While one types a comment, what is declared behind it is known.
TEST(Lexer, EndsAnOpenCommentBeforeTheNextDeclaration) {
  Reporter reporter;
  const std::string open = "a /* b\n * option\n statement\n\n\toption c { /* e\n}\nfloat f; /* g";
  EXPECT_THAT(describedTokens(open, reporter),
              ElementsAre("'a'", "'option'", "'c'", "'{'", "'float'", "'f'", "';'"));
  EXPECT_EQ(test::errors(reporter.take()), "f:1:3: comment is not closed, expected '*/'\n");
  EXPECT_THAT(describedTokens("a /* b\noption c { /* d */ e", reporter), ElementsAre("'a'", "'e'"));
}

TEST(Lexer, SkipsAllKindsOfComments) {
  Reporter reporter;
  EXPECT_THAT(describedTokens("a // b\n/* c\n * d */ e /** f */ /*** g ***/ h /**/ i", reporter),
              ElementsAre("'a'", "'e'", "'h'", "'i'"));
}

TEST(Lexer, KeepsStringsAndRangesWhole) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("f"), "\"mm/s\" [-1 .. 1]", reporter);
  const Token string = lexer.next();
  EXPECT_EQ(string.kind, TokenKind::string);
  EXPECT_EQ(string.text, "mm/s");
  const Token range = lexer.next();
  EXPECT_EQ(range.kind, TokenKind::range);
  EXPECT_EQ(range.text, "-1 .. 1");
}

TEST(Lexer, ReadsNumbersWithAndWithoutExponent) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("f"), "12 12.5 1e3 2.5E-2", reporter);
  EXPECT_EQ(lexer.next().number, 12);
  EXPECT_EQ(lexer.next().number, 12.5);
  EXPECT_EQ(lexer.next().number, 1000);
  EXPECT_EQ(lexer.next().number, 0.025);
}

TEST(Lexer, TellsKeywordsFromNames) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("f"), "state state_time states action.x", reporter);
  EXPECT_EQ(lexer.next().kind, TokenKind::keyword);
  EXPECT_EQ(lexer.next().kind, TokenKind::keyword);
  EXPECT_EQ(lexer.next().kind, TokenKind::identifier);
  EXPECT_EQ(lexer.next().kind, TokenKind::identifier);
}

TEST(Lexer, CountsLinesAndColumnsInLetters) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("f"), "\xEF\xBB\xBF/* ä */ a\r\n\tb", reporter);
  const Token a = lexer.next();
  EXPECT_EQ(a.location.line, 1);
  EXPECT_EQ(a.location.column, 9);
  const Token b = lexer.next();
  EXPECT_EQ(b.location.line, 2);
  EXPECT_EQ(b.location.column, 2);
}

TEST(Lexer, TellsWhatIsNoToken) {
  EXPECT_EQ(lexicalErrors("a $ b"), "f:1:3: unexpected character '$'\n");
  EXPECT_EQ(lexicalErrors("a & b"), "f:1:3: unexpected character '&'; did you mean '&&'?\n");
  EXPECT_EQ(lexicalErrors("a # b $"),
            "f:1:3: unexpected character '#'; comments begin with '//'\n");
  EXPECT_EQ(lexicalErrors(".5"), "f:1:1: a number begins with a digit, expected '0.'\n");
  EXPECT_EQ(lexicalErrors("@ a"), "f:1:1: unexpected character '@'\n");
  EXPECT_EQ(lexicalErrors(std::string("a \0 b", 5)), "f:1:3: unexpected character with code 0\n");
  EXPECT_EQ(lexicalErrors("ä"), "f:1:1: unexpected character with code 195\n");
  EXPECT_EQ(lexicalErrors("12.x"), "f:1:1: '12.x' is not a number\n");
  EXPECT_EQ(lexicalErrors("1e999"), "f:1:1: number '1e999' is out of range\n");
}

TEST(Lexer, CutsNamesThatNobodyWrites) {
  EXPECT_EQ(lexicalErrors(" " + std::string(501, 'a')),
            "f:1:2: name is longer than 500 characters\n");
  EXPECT_EQ(lexicalErrors(std::string(500, 'a')), "");
}

TEST(Lexer, TellsWhatIsNotClosed) {
  EXPECT_EQ(lexicalErrors("a /* b"), "f:1:3: comment is not closed, expected '*/'\n");
  EXPECT_EQ(lexicalErrors("\"a\n b"), "f:1:1: string is not closed, expected '\"'\n");
  EXPECT_EQ(lexicalErrors("\"a;\n\"b\";"), "f:1:1: string is not closed, expected '\"'\n");
  EXPECT_EQ(lexicalErrors(" [0..1"), "f:1:2: range is not closed, expected ']'\n");
}

}  // namespace
}  // namespace xabsl
