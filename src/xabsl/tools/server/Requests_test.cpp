#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "base/ParseJson.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/tools/server/Server.h"

namespace xabsl::server {
namespace {

using OutlineJson = nlohmann::json;

/// One declaration a line, so that a broken line takes one at most.
const std::string typedText = R"(/** Of the ball. */
namespace ball("Ball") {
  enum ball.color { orange, white };
  float input ball.x [0..100] "mm";
  bool input ball.seen;
  float input scaled(float value; bool both;);
  enum ball.color output ball.chosen;
  float internal memory;
  float const near = 150 "mm";
}
namespace walking("Walking") {
  behavior walk {
    float x;
    bool fast;
  }
  behavior stand { }
}
option search {
  float @x [0..1];
  bool @fast;
  initial state look {
    decision {
      if (ball.seen && @x > 2) goto run;
      else stay;
    }
    action {
      walk(x = @x, fast = true);
      memory = scaled(value = ball.x, both = false);
    }
  }
  state run {
    decision {
      if (state_time > 5) {
        if (@fast) goto look;
        else stay;
      } else goto look;
    }
    action { }
  }
}
option main {
  common decision {
    if (ball.seen) goto play;
  }
  common action {
    ball.chosen = orange;
  }
  initial target state begin {
    decision {
      else stay;
    }
    action {
      search option(x = 1, fast = true);
    }
  }
  target state play capacity 2 {
    decision {
      else goto begin;
    }
    action {
      stand();
    }
  }
}
agent main("Main", main);
)";

/// A server whose editor has one text open.
class OpenText {
 public:
  explicit OpenText(const std::string& text) {
    ask("initialize", OutlineJson::object());
    send({{"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", uri}, {"text", text}}}}}});
  }
  OutlineJson ask(const std::string& method, OutlineJson parameters) {
    parameters["textDocument"] = {{"uri", uri}};
    send({{"id", 1}, {"method", method}, {"params", parameters}});
    return answer_.at("result");
  }
  OutlineJson outline() { return ask("textDocument/documentSymbol", OutlineJson::object()); }

 private:
  static constexpr const char* uri = "file:///main.xabsl";
  void send(const OutlineJson& message) { server_.handle(message.dump()); }

  OutlineJson answer_;
  Server server_{
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [this](const std::string& text) { answer_ = *gt::parseJsonAs<OutlineJson>(text, ""); }};
};

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

/// Names beside what is being typed lead to their declarations, and are offered.
TEST(Requests, KnowNamesInABrokenState) {
  std::string text = typedText;
  text.replace(text.find("if (ball.seen && @x > 2) goto run;"), 34, "if (ball.");
  text.replace(text.find("walking(\"Walking\") {"), 20, "walking(\"Wal");
  OpenText open{text};
  const auto at = [&](const std::string& piece) {
    const std::size_t place = text.find(piece);
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    return OutlineJson{
        {"position", {{"line", line}, {"character", place - text.rfind('\n', place) - 1}}}};
  };
  const OutlineJson walk = open.ask("textDocument/definition", at("walk(x = @x"));
  EXPECT_EQ(walk["range"]["start"], at("walk {")["position"]);
  const OutlineJson offered = open.ask("textDocument/completion", at("memory = scaled"));
  std::vector<std::string> labels;
  for (const OutlineJson& item : offered) labels.push_back(item["label"]);
  EXPECT_THAT(labels, testing::IsSupersetOf({"walk", "stand", "search", "memory"}));
  EXPECT_THAT(labels, testing::Not(testing::Contains("")));
}

}  // namespace
}  // namespace xabsl::server
