#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using testing::HasSubstr;

/// A behavior that uses every construct of the language.
const std::string wholeBehavior = R"(/*** Title: Test */
include "main.xabsl";
namespace main("Symbols") {
  enum mode { fast, slow };
  /** How far. */
  float input ball.distance [0..6000] "mm";
  bool input ball.seen;
  enum mode input how;
  float input scaled(float value; enum mode by;);
  float output speed "mm/s";
  bool output led;
  enum mode output head;
  float internal memory;
  float const near = -1.5e2 "mm";
}
namespace main("Behaviors") { behavior walk { float x; enum mode how; } behavior both { } }
option both { initial state s { action { } } }
option sub {
  float @v [0..1]; bool @b; enum mode @m;
  initial state s { decision { if (@b || @v > 1 && !(@m == slow)) goto t; else stay; }
                    action { walk(x = -@v % 3, how = @m); } }
  target state t { action { led = !led; } }
}
option main {
  common decision { if (ball.seen && state_time > 10) { if (action_done) goto t; else stay; }
                    else if (how == mode.slow) goto s; }
  common action { head = ball.seen ? fast : slow; both option(); both behavior(); }
  initial target state s { decision { else goto t; } action { sub(v = (1 + 2) * near / 4, b = true); } }
  state t { action { speed = scaled(value = option_time, by = how) - ball.distance; memory = 1; } }
}
agent main("Main", main);
agent other("Other", sub);
)";

Symbols surroundings() {
  enum class Mode { slow, fast };
  Symbols symbols;
  symbols.enumeration<Mode>("mode", {"slow", "fast"});
  symbols.input("ball.distance", [] { return 100.0; });
  symbols.input("ball.seen", [] { return true; });
  symbols.input("how", [] { return Mode::fast; });
  symbols.input("scaled", {"value", "by"}, [](double value, Mode) { return value; });
  symbols.output("speed", [](double) {});
  symbols.output("led", [](bool) {});
  symbols.output("head", [](Mode) {});
  symbols.behavior("walk", {"x", "how"}, [](double, Mode) {});
  symbols.behavior("both", [] {});
  return symbols;
}

/// Compiles, links and runs whatever the text is. Either it is sound, or there is an error in a
/// file. Returns whether it ran.
bool survives(const std::string& text, const Symbols& symbols) {
  const Compilation compilation = compile("main.xabsl", {{"main.xabsl", text}});
  EXPECT_NE(compilation.behavior.has_value(), fails(compilation.diagnostics)) << text;
  for (const Diagnostic& diagnostic : compilation.diagnostics) {
    EXPECT_EQ(diagnostic.file, "main.xabsl");
    EXPECT_FALSE(diagnostic.message.empty());
  }
  if (!compilation.behavior) return false;
  Engine::Creation creation = Engine::create(*compilation.behavior, symbols);
  EXPECT_NE(creation.engine.has_value(), fails(creation.diagnostics)) << text;
  if (!creation.engine) return false;
  for (const std::int64_t now : {0, 8, 16, 100}) creation.engine->execute(now);
  EXPECT_FALSE(creation.engine->activations().empty());
  return true;
}

std::size_t pick(std::mt19937& random, std::size_t size) {
  return random() % size;
}

/// Removes, doubles, exchanges or inserts single characters.
std::string mutateCharacters(std::string text, std::mt19937& random) {
  static constexpr std::string_view letters = "{}();,=!-+*/%<>?:&|@\".[]a0\n\0\xff";
  for (std::size_t i = 0; i <= pick(random, 3) && !text.empty(); ++i) {
    const std::size_t position = pick(random, text.size());
    const char letter = letters[pick(random, letters.size())];
    switch (pick(random, 4)) {
      case 0:
        text.erase(position, 1 + pick(random, 20));
        break;
      case 1:
        text.insert(position, 1, letter);
        break;
      case 2:
        text[position] = letter;
        break;
      default:
        text.insert(position, text.substr(pick(random, text.size()), pick(random, 40)));
    }
  }
  return text;
}

/// The same with whole tokens, which gets deeper into parser and analyzer.
std::string mutateTokens(const std::vector<std::string>& tokens, std::mt19937& random) {
  std::vector<std::string> mutated = tokens;
  for (std::size_t i = 0; i <= pick(random, 2); ++i) {
    const std::size_t position = pick(random, mutated.size());
    const std::string& other = tokens[pick(random, tokens.size())];
    switch (pick(random, 3)) {
      case 0:
        mutated.erase(mutated.begin() + static_cast<std::ptrdiff_t>(position));
        break;
      case 1:
        mutated.insert(mutated.begin() + static_cast<std::ptrdiff_t>(position), other);
        break;
      default:
        mutated[position] = other;
    }
  }
  std::string text;
  for (const std::string& token : mutated) text += token + " ";
  return text;
}

std::vector<std::string> tokensOf(const std::string& text) {
  Reporter reporter;
  Lexer lexer(reporter.addFile("f"), text, reporter);
  std::vector<std::string> tokens;
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
    const std::string word(token.text);
    tokens.push_back(token.kind == TokenKind::parameter ? "@" + word
                     : token.kind == TokenKind::string  ? "\"" + word + "\""
                     : token.kind == TokenKind::range   ? "[" + word + "]"
                                                        : word);
  }
  return tokens;
}

TEST(Robustness, TheUnchangedBehaviorRuns) {
  EXPECT_TRUE(survives(wholeBehavior, surroundings()));
  std::string joined;
  for (const std::string& token : tokensOf(wholeBehavior)) joined += token + " ";
  EXPECT_TRUE(survives(joined, surroundings()));
}

TEST(Robustness, SurvivesTruncationAnywhere) {
  const Symbols symbols = surroundings();
  for (std::size_t length = 0; length < wholeBehavior.size(); ++length)
    survives(wholeBehavior.substr(0, length), symbols);
}

TEST(Robustness, SurvivesThousandsOfChangedCharacters) {
  const Symbols symbols = surroundings();
  std::mt19937 random(1);
  int ran = 0;
  for (int i = 0; i < 5000; ++i) ran += survives(mutateCharacters(wholeBehavior, random), symbols);
  EXPECT_GT(ran, 0);     // a change in a comment or a unit harms nothing
  EXPECT_LT(ran, 2500);  // most others do
}

TEST(Robustness, SurvivesThousandsOfChangedTokens) {
  const Symbols symbols = surroundings();
  const std::vector<std::string> tokens = tokensOf(wholeBehavior);
  std::mt19937 random(2);
  int ran = 0;
  for (int i = 0; i < 5000; ++i) ran += survives(mutateTokens(tokens, random), symbols);
  EXPECT_GT(ran, 0);
  EXPECT_LT(ran, 2500);
}

std::string repeated(std::string_view text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

std::string withAction(const std::string& action) {
  return "namespace main(\"M\") { float internal m; float input f(float x;); }"
         "option main { initial state s { action { " +
         action + " } } } agent a(\"A\", main);";
}

TEST(Robustness, RefusesDeepNesting) {
  const int deep = 100'000;
  const std::string tooDeep = "nested too deeply, at most 200 levels";
  EXPECT_THAT(test::errorsIn(withAction("m = " + repeated("(", deep))), HasSubstr(tooDeep));
  EXPECT_THAT(test::errorsIn(withAction("m = " + repeated("-", deep))), HasSubstr(tooDeep));
  EXPECT_THAT(test::errorsIn(withAction("m = " + repeated("f(x = ", deep))), HasSubstr(tooDeep));
  const std::string decision = "option main { initial state s { decision { ";
  EXPECT_THAT(test::errorsIn(decision + repeated("{", deep)), HasSubstr(tooDeep));
  EXPECT_THAT(test::errorsIn(decision + repeated("if (true) ", deep)), HasSubstr(tooDeep));
  EXPECT_THAT(test::errorsIn(withAction("m = 1" + repeated(" + 1", deep) + ";")),
              HasSubstr("expression is too long, at most 200 levels"));
}

TEST(Robustness, TakesLongChains) {
  const int many = 20'000;
  EXPECT_EQ(test::errorsIn(withAction(repeated("m = 1; ", many))), "");
  EXPECT_EQ(test::errorsIn(withAction("m = true" + repeated(" && true", many) + " ? 1 : 2;")), "");
  const std::string text = "option main { initial state s { decision { " +
                           repeated("if (false) goto s; else ", many) +
                           "stay; } action { } } } agent a(\"A\", main);";
  const Behavior behavior = test::compiled(text);
  Engine engine = std::move(*Engine::create(behavior, Symbols()).engine);
  engine.execute(0);
  EXPECT_EQ(engine.activations().size(), 1u);
}

TEST(Robustness, TakesChainsOfIncludes) {
  VirtualFiles files;
  const int many = 2000;
  for (int i = 0; i < many; ++i)
    files["f" + std::to_string(i) + ".xabsl"] =
        "include \"f" + std::to_string((i + 1) % many) + ".xabsl\";";
  files["f1999.xabsl"] += "option f1999 { initial state s { action { } } } agent a(\"A\", f1999);";
  const Compilation compilation = compile("f0.xabsl", files);
  EXPECT_EQ(test::errors(compilation.diagnostics), "");
  EXPECT_TRUE(compilation.behavior);
}

TEST(Robustness, RefusesTooManyElementsAndParameters) {
  std::string elements = "a";
  std::string parameters;
  for (int i = 0; i < 1000; ++i) elements += ", e" + std::to_string(i);
  for (int i = 0; i < 101; ++i) parameters += "p" + std::to_string(i) + ";";
  EXPECT_THAT(test::errorsIn("namespace main(\"M\") { enum e { " + elements +
                             " }; } agent a(\"A\", main);"),
              HasSubstr("enumeration 'e' has more than 1000 elements"));
  EXPECT_THAT(test::errorsIn("namespace main(\"M\") { behavior b { " + parameters +
                             " } } agent a(\"A\", main);"),
              HasSubstr("more than 100 parameters"));
}

TEST(Robustness, SurvivesClocksThatJump) {
  Engine engine = std::move(*Engine::create(test::compiled(wholeBehavior), surroundings()).engine);
  for (const std::int64_t now :
       {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
        std::int64_t{0}, std::int64_t{-5}})
    engine.execute(now);
  EXPECT_FALSE(engine.activations().empty());
}

/// What is reported first about a behavior in XML.
std::string firstReported(const VirtualFiles& files) {
  const Compilation compilation = compile("a.xml", files);
  EXPECT_FALSE(compilation.behavior);
  return compilation.diagnostics.empty() ? "" : compilation.diagnostics.front().message;
}

TEST(Robustness, XmlThatGrowsWithoutBoundsIsRefused) {
  std::string bomb = "<!DOCTYPE a [<!ENTITY e0 \"ha\">";
  for (int i = 1; i < 30; ++i) {
    const std::string last = "&e" + std::to_string(i - 1) + ";";
    bomb += "<!ENTITY e" + std::to_string(i) + " \"" + last + last + "\">";
  }
  EXPECT_NE(firstReported({{"a.xml", bomb + "]><a>&e29;</a>"}}), "");
  const std::string text(100'000, 'x');
  EXPECT_NE(firstReported({{"a.xml", "<!DOCTYPE a [<!ENTITY e \"" + text + "\">]><a>" +
                                         repeated("&e;", 10'000) + "</a>"}}),
            "");
  VirtualFiles files;
  for (int i = 0; i < 30; ++i) {
    const std::string next = std::to_string(i + 1) + ".xml";
    files[i == 0 ? "a.xml" : std::to_string(i) + ".xml"] =
        "<!DOCTYPE a [<!ENTITY e SYSTEM \"" + next + "\">]><a>" + repeated("&e;", 3) + "</a>";
  }
  files["30.xml"] = "<a/>";
  EXPECT_EQ(firstReported(files), "too large, with all that is included");
  EXPECT_EQ(firstReported({{"a.xml", "<a>" + repeated("<a/>", 350'000) + "</a>"}}),
            "the file has too many elements");
}

TEST(Robustness, XmlThatIncludesItselfIsRefused) {
  const std::string entity = "<!DOCTYPE a [<!ENTITY e SYSTEM \"b.xml\">]><a>&e;</a>";
  const std::string include =
      "<a xmlns:xi=\"http://www.w3.org/2001/XInclude\"><xi:include href=\"a.xml\"/></a>";
  EXPECT_EQ(firstReported({{"a.xml", entity}, {"b.xml", include}}), "'a.xml' includes itself");
  EXPECT_EQ(firstReported({{"a.xml", include}}), "'a.xml' includes itself");
  const std::string outside = "<!DOCTYPE a SYSTEM \"a.dtd\"><a>&e;</a>";
  EXPECT_EQ(firstReported({{"a.xml", outside}, {"a.dtd", "<!ENTITY e SYSTEM \"a.xml\">"}}),
            "'a.xml' includes itself");
  EXPECT_EQ(firstReported({{"a.xml", outside}}), "cannot include 'a.dtd': there is no such file");
  EXPECT_EQ(firstReported(
                {{"a.xml", outside}, {"a.dtd", "<!-- <!ENTITY e SYSTEM \"a.xml\"> --><!ENTITY"}}),
            "entity 'e' is not declared in a.dtd");
  EXPECT_EQ(firstReported({{"a.xml", "<!DOCTYPE a SYSTEM \"/etc/passwd\"><a>&e;</a>"}}),
            "cannot include '/etc/passwd': it lies outside of the folder of a.xml");
}

TEST(Robustness, XmlThatIsTooDeepOrTooWideIsRefused) {
  EXPECT_NE(firstReported({{"a.xml", repeated("<a>", 100'000)}}), "");
  EXPECT_NE(firstReported({{"a.xml", repeated("<a>", 100'000) + repeated("</a>", 100'000)}}), "");
  EXPECT_EQ(firstReported({{"a.xml", repeated("<a>", 250) + repeated("</a>", 250)}}).substr(0, 11),
            "element 'a'");
  std::string attributes = "<a";
  for (int i = 0; i < 20'000; ++i) attributes += " a" + std::to_string(i) + "=\"\"";
  EXPECT_EQ(firstReported({{"a.xml", attributes + "/>"}}), "the tag is longer than 16 KiB");
  EXPECT_EQ(firstReported({{"a.xml", "<" + std::string(1'000'000, 'a') + "/>"}}),
            "the tag is longer than 16 KiB");
  EXPECT_NE(firstReported({{"a.xml", std::string(3'000'000, '<')}}), "");
  EXPECT_NE(firstReported({{"a.xml", "<!--" + repeated("<!--", 400'000)}}), "");
}

}  // namespace
}  // namespace xabsl
