#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "xabsl/tools/server/OpenText.h"
#include "xabsl/tools/server/Protocol.h"

namespace xabsl::server {
namespace {

/// The semantic tokens of a line, each as text:type and its modifiers.
std::vector<std::string> tokensOf(const std::string& text, int wanted) {
  const OutlineJson legend = semanticLegend();
  const OutlineJson data =
      OpenText{text}.ask("textDocument/semanticTokens/full", OutlineJson::object())["data"];
  std::vector<std::string> lines, tokens;
  std::istringstream stream{text};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::size_t line = 0, character = 0;
  EXPECT_EQ(data.size() % 5, 0u);
  for (std::size_t i = 0; i + 4 < data.size(); i += 5) {
    const auto number = [&](std::size_t k) { return data[i + k].get<std::size_t>(); };
    character = number(1) + (number(0) == 0 ? character : 0);
    line += number(0);
    EXPECT_LT(line, lines.size());
    EXPECT_LE(character + number(2), lines.at(line).size());
    std::string token = lines.at(line).substr(character, number(2)) + ":" +
                        legend["tokenTypes"].at(number(3)).get<std::string>();
    for (std::size_t bit = 0; bit < legend["tokenModifiers"].size(); ++bit)
      if (number(4) >> bit & 1) token += " " + legend["tokenModifiers"][bit].get<std::string>();
    if (static_cast<int>(line) == wanted) tokens.push_back(token);
  }
  return tokens;
}

int lineWith(const std::string& text, const std::string& piece) {
  const auto place = text.begin() + static_cast<std::ptrdiff_t>(text.find(piece));
  return static_cast<int>(std::count(text.begin(), place, '\n'));
}

using Tokens = std::vector<std::string>;

TEST(SemanticTokens, TellWhatNamesStandFor) {
  const auto at = [](const std::string& piece) {
    return tokensOf(typedText, lineWith(typedText, piece));
  };
  EXPECT_EQ(at("namespace ball("), Tokens{"ball:namespace declaration"});
  EXPECT_EQ(at("enum ball.color {"),
            (Tokens{"ball.color:enum declaration", "orange:enumMember declaration",
                    "white:enumMember declaration"}));
  EXPECT_EQ(at("float input ball.x"), Tokens{"ball.x:variable declaration readonly"});
  EXPECT_EQ(at("float const near"), Tokens{"near:variable declaration readonly"});
  EXPECT_EQ(at("state run {"), Tokens{"run:event declaration"});
  EXPECT_EQ(at("if (ball.seen && @x"),
            (Tokens{"ball.seen:variable readonly", "x:parameter", "run:event"}));
  EXPECT_EQ(at("walk(x = @x"),
            (Tokens{"walk:function", "x:parameter", "x:parameter", "fast:parameter"}));
  EXPECT_EQ(at("memory = scaled"),
            (Tokens{"memory:variable", "scaled:variable readonly", "value:parameter",
                    "ball.x:variable readonly", "both:parameter"}));
  EXPECT_EQ(at("agent main"), (Tokens{"main:type declaration", "main:class"}));
}

/// While a line is typed, the others keep their colors, and columns count as editors count.
TEST(SemanticTokens, StayWhileOneTypes) {
  std::string text = typedText;
  text.replace(text.find("if (ball.seen && @x > 2) goto run;"), 34, "if (ball.");
  EXPECT_EQ(tokensOf(text, lineWith(text, "memory = scaled")).size(), 5u);
  text.replace(text.find("memory = scaled"), 0, "/* \xf0\x9f\x98\x80 */ ");
  const OutlineJson data =
      OpenText{text}.ask("textDocument/semanticTokens/full", OutlineJson::object())["data"];
  int line = 0;
  std::vector<int> begins;
  for (std::size_t i = 0; i < data.size(); i += 5) {
    line += data[i].get<int>();
    if (line == lineWith(text, "memory = scaled")) begins.push_back(data[i + 1]);
  }
  ASSERT_EQ(begins.size(), 5u);
  EXPECT_EQ(begins[0], 6 + 9) << "the sign counts two";
}

}  // namespace
}  // namespace xabsl::server
