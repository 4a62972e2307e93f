#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "xabsl/language/Lexer.h"
#include "xabsl/tools/server/OpenText.h"

namespace xabsl::server {
namespace {

struct OutlineEntry {
  std::string name;
  int line;
  int parentLine;  ///< -1: none
};

std::vector<OutlineEntry> entriesOf(const OutlineJson& outline) {
  const auto lineOf = [](const OutlineJson& symbol) {
    return symbol["selectionRange"]["start"]["line"].get<int>();
  };
  std::vector<OutlineEntry> entries;
  for (const OutlineJson& symbol : outline) {
    entries.push_back({symbol["name"], lineOf(symbol), -1});
    for (const OutlineJson& child : symbol["children"])
      entries.push_back({child["name"], lineOf(child), lineOf(symbol)});
  }
  return entries;
}

using Place = std::pair<int, int>;
Place placeOf(const OutlineJson& position) {
  return {position["line"].get<int>(), position["character"].get<int>()};
}
bool liesWithin(const OutlineJson& inner, const OutlineJson& outer) {
  return placeOf(outer["start"]) <= placeOf(inner["start"]) &&
         placeOf(inner["start"]) <= placeOf(inner["end"]) &&
         placeOf(inner["end"]) <= placeOf(outer["end"]);
}

/// What is wrong with the ranges: a name lies in its declaration, a child in its parent, and what
/// follows each other in the text does not overlap.
std::string wrongRange(const OutlineJson& symbols, bool inOrder) {
  const OutlineJson* before = nullptr;
  for (const OutlineJson& symbol : symbols) {
    const std::string name = symbol["name"];
    const OutlineJson& range = symbol["range"];
    if (!liesWithin(symbol["selectionRange"], range)) return "the name of " + name;
    if (inOrder && before && placeOf((*before)["end"]) > placeOf(range["start"]))
      return name + " overlaps";
    before = &range;
    if (!symbol.contains("children")) continue;
    for (const OutlineJson& child : symbol["children"])
      if (!liesWithin(child["range"], range))
        return child["name"].get<std::string>() + " in " + name;
    if (const std::string wrong = wrongRange(symbol["children"], symbol["kind"] == 5);
        !wrong.empty())
      return wrong;
  }
  return {};
}

struct Typed {
  std::string text;
  int line;  ///< that is broken, from 0
  std::string what;
  int lines = 0;  ///< that were added there
};

/// The text with each of its words deleted, something inserted before each, and cut off there.
std::vector<Typed> typings() {
  constexpr std::array words{"if (", "x",      "{",         "}",       "(",      ")",    ";",
                             "\"",   "[",      "@",         "= 3",     "float ", "/*",   "&",
                             "0.x ", "state ", "decision ", "action ", "goto ",  "} } ", "x "};
  std::size_t next = 0;
  std::vector<Typed> all;
  Reporter reporter;
  Lexer lexer(reporter.addFile("main.xabsl"), typedText, reporter);
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
    auto begin = static_cast<std::size_t>(token.text.data() - typedText.data());
    std::size_t size = token.text.size();
    if (token.kind == TokenKind::parameter) --begin, ++size;
    if (token.kind == TokenKind::string || token.kind == TokenKind::range) --begin, size += 2;
    const std::string before = typedText.substr(0, begin), behind = typedText.substr(begin);
    const int line = token.location.line - 1;
    const std::string where =
        " before '" + std::string{token.text} + "' in line " + std::to_string(line + 1);
    // Each place gets some of the words, in turn.
    for (int i = 0; i < 2; ++i) {
      const std::string word{words[next++ % words.size()]};
      all.push_back({before + word + behind, line, word + where});
    }
    // A new declaration before another one.
    if (token.location.column == 1)
      for (const char* word : {"option ", "option new {", "namespace ", "agent "})
        all.push_back({before + word + "\n" + behind, line, word + where, 1});
    all.push_back({before + behind.substr(size), line, "nothing" + where});
    all.push_back({before + behind.substr(behind.find('\n')), line, "the end of the line" + where});
    all.push_back({before, line, "the end" + where});
  }
  return all;
}

TEST(Outline, KeepsWhatStandsBesideALineThatIsBeingTyped) {
  const std::vector<OutlineEntry> whole = entriesOf(OpenText{typedText}.outline());
  ASSERT_EQ(whole.size(), 18u);
  std::string faults;
  for (const Typed& typed : typings()) {
    const OutlineJson outline = OpenText{typed.text}.outline();
    const std::vector<OutlineEntry> found = entriesOf(outline);
    const bool cut = typed.what.starts_with("the end before");
    const auto isBroken = [&](int line) { return typed.lines == 0 && line == typed.line; };
    const auto moved = [&](int line) { return line + (line >= typed.line ? typed.lines : 0); };
    for (const OutlineEntry& entry : whole) {
      if (isBroken(entry.line) || (cut && entry.line > typed.line)) continue;
      const auto same = std::find_if(found.begin(), found.end(), [&](const OutlineEntry& one) {
        return one.name == entry.name && one.line == moved(entry.line);
      });
      if (same == found.end())
        faults += typed.what + ": " + entry.name + " is lost\n";
      else if (!isBroken(entry.parentLine) && same->parentLine != moved(entry.parentLine))
        faults += typed.what + ": " + entry.name + " is elsewhere\n";
    }
    if (const std::string wrong = wrongRange(outline, true); !wrong.empty())
      faults += typed.what + ": " + wrong + "\n";
  }
  EXPECT_EQ(faults, "");
}

TEST(Outline, ShowsWhatHasNoNameYet) {
  std::string text = typedText;
  text.replace(text.find("option main {"), 13, "option {");
  text.replace(text.find("initial target state begin"), 26, "initial target state");
  const OutlineJson outline = OpenText{text}.outline();
  EXPECT_EQ(outline[3]["name"], "<option>");
  EXPECT_EQ(outline[3]["children"][0]["name"], "<state>");
  EXPECT_EQ(outline[3]["children"][1]["name"], "play");
}

/// An option of a behavior in XML, one declaration a line.
const std::string typedXml = R"(<?xml version="1.0"?>
<option xmlns="http://www.ki.informatik.hu-berlin.de/XABSL2.1" name="play" initial-state="look">
  <!-- What it
       looks for. -->
  <common-decision-tree><if><transition-to-state ref="go"/></if></common-decision-tree>
  <state name="look">
    <subsequent-basic-behavior ref="stand"/>
    <set-output-symbol ref="head" value="search"/>
    <decision-tree>
      <transition-to-state ref="look"/>
    </decision-tree>
  </state>
  <state name="go" is-target-state="true">
    <subsequent-option ref="walk"/>
  </state>
  <state name="done"/>
</option>
)";
constexpr std::array statesOfXml{"look", "go", "done"};

/// The text with each of its tags deleted, with something inserted before and behind each, and cut
/// off there.
std::vector<Typed> xmlTypings() {
  constexpr std::array words{"<",  "<state", "<state name=", "<state name=\"", "</",
                             "\"", "<if",    "<!--",         "</if>",          "&"};
  std::size_t next = 0;
  std::vector<Typed> all;
  const std::size_t first =
      typedXml.find(" name=");  // without its namespace it is another language
  int line = 2;
  for (std::size_t i = first; i < typedXml.size(); ++i) {
    line += typedXml[i] == '\n';
    if (std::string_view{"<>\"= /"}.find(typedXml[i]) == std::string_view::npos) continue;
    const std::string before = typedXml.substr(0, i), behind = typedXml.substr(i);
    const std::string where = " in line " + std::to_string(line) + " before " + behind.substr(0, 9);
    for (int k = 0; k < 3; ++k) {
      const std::string word{words[next++ % words.size()]};
      all.push_back({before + word + behind, line - 1, word + where});
    }
    all.push_back({before + behind.substr(1), line - 1, "nothing" + where});
    all.push_back(
        {before + behind.substr(behind.find('\n')), line - 1, "the end of the line" + where});
    all.push_back({before, line - 1, "the end" + where});
  }
  return all;
}

TEST(Outline, KeepsStatesInXmlBesideALineThatIsBeingTyped) {
  const std::vector<OutlineEntry> whole = entriesOf(OpenText{typedXml}.outline());
  ASSERT_EQ(whole.size(), 1 + statesOfXml.size());
  std::string faults;
  for (const Typed& typed : xmlTypings()) {
    const OutlineJson outline = OpenText{typed.text}.outline();
    const std::vector<OutlineEntry> found = entriesOf(outline);
    const bool cut = typed.what.starts_with("the end in");
    for (const OutlineEntry& entry : whole) {
      if (entry.line == typed.line || (cut && entry.line > typed.line)) continue;
      const auto same = std::ranges::find_if(found, [&](const OutlineEntry& one) {
        return one.name == entry.name && one.line == entry.line &&
               one.parentLine == entry.parentLine;
      });
      if (same == found.end()) faults += typed.what + ": " + entry.name + " is lost\n";
    }
    if (const std::string wrong = wrongRange(outline, true); !wrong.empty())
      faults += typed.what + ": " + wrong + "\n";
  }
  EXPECT_EQ(faults, "");
}

TEST(Outline, HasTheExtentOfElements) {
  const OutlineJson option = OpenText{typedXml}.outline()[0];
  EXPECT_EQ(option["children"][0]["range"]["start"]["line"], 5);
  EXPECT_EQ(option["children"][0]["range"]["end"]["line"], 11);
  EXPECT_EQ(option["children"][2]["kind"], 24);
}

/// What the time depends on is the text, not the text times its longest line.
TEST(Outline, IsMadeOfOneLongLine) {
  constexpr int many = 20'000;
  std::string text = "<option xmlns=\"http://www.ki.informatik.hu-berlin.de/XABSL2.1\" name=\"a\">";
  for (int i = 0; i < many; ++i) text += "<state name=\"b\"/>";
  OpenText open{text};
  EXPECT_EQ(open.outline()[0]["children"].size(), std::size_t{many});
  EXPECT_EQ(open.ask("textDocument/foldingRange", OutlineJson::object()), OutlineJson::array());
}

/// Editors send all files of XML.
TEST(Outline, IsEmptyForXmlOfAnotherLanguage) {
  OpenText page{"<html>\n<option name=\"a\">\n</option>\n</html>"};
  EXPECT_EQ(page.outline(), OutlineJson::array());
  EXPECT_EQ(page.ask("textDocument/foldingRange", OutlineJson::object()), OutlineJson::array());
}

std::string foldsOf(const std::string& text) {
  std::string folds;
  for (const OutlineJson& fold :
       OpenText{text}.ask("textDocument/foldingRange", OutlineJson::object()))
    folds += fold["startLine"].dump() + "-" + fold["endLine"].dump() + fold.value("kind", "") + " ";
  return folds;
}

TEST(FoldingRanges, AreBlocksCommentsAndIncludes) {
  EXPECT_EQ(
      foldsOf("include \"a.xabsl\";\ninclude \"b.xabsl\";\n\n// One\n// two\n"
              "option a {  // not\n  initial state b {  // this\n    decision { stay; }\n  }\n}\n"
              "/* of\n several\n */"),
      "6-7 5-8 10-12comment 0-1imports 3-4comment ");
  EXPECT_EQ(foldsOf("option a {\n  state b {\n  }\n  \"\n  state c {\n    &\n  }\n"), "4-5 ");
  EXPECT_EQ(foldsOf(typedXml), "1-15 5-10 8-9 12-13 2-3comment ");
}

}  // namespace
}  // namespace xabsl::server
