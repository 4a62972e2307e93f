#include "xabsl/engine/Linker.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

enum class Style { slow, fast };
enum class Other { a };

const std::string program = R"(namespace main("M") {
enum mode { fast, slow };
float input ball.distance;
enum mode input how;
float input scaled(float value; bool twice;);
float output speed;
enum step { one, two };
enum step internal current;
behavior walk { float x; enum mode style; }
}
option main { initial state s { decision {
if (ball.distance > 1 && how == fast) stay; else stay; } action {
speed = scaled(value = 1); current = two; walk(); } } }
agent main("Main", main);)";

/// Registers all that the behavior needs; a test then takes something away or makes it wrong.
Symbols complete() {
  Symbols symbols;
  symbols.enumeration<Style>("mode", {"slow", "fast"});
  symbols.input("ball.distance", [] { return 1.0; });
  symbols.input("how", [] { return Style::slow; });
  symbols.input("scaled", {"value", "twice"}, [](double value, bool) { return value; });
  symbols.output("speed", [](double) {});
  symbols.behavior("walk", {"x", "style"}, [](double, Style) {});
  return symbols;
}

std::string linkErrors(const Symbols& symbols) {
  const Engine::Creation creation = Engine::create(test::compiled(program), symbols);
  EXPECT_EQ(creation.engine.has_value(), creation.diagnostics.empty());
  return test::errors(creation.diagnostics);
}

TEST(Linker, AcceptsWhatIsComplete) {
  Symbols symbols = complete();
  EXPECT_EQ(linkErrors(symbols), "");
  symbols.input("never.used", [] { return 1; });
  EXPECT_EQ(linkErrors(symbols), "");
}

TEST(Linker, TellsAllThatIsMissing) {
  EXPECT_EQ(linkErrors(Symbols()),
            "main.xabsl:3:13: input symbol 'ball.distance' is not registered, needed by "
            "option main (main.xabsl:12)\n"
            "main.xabsl:4:17: input symbol 'how' is not registered, needed by option main "
            "(main.xabsl:12)\n"
            "main.xabsl:5:13: input symbol 'scaled' is not registered, needed by option "
            "main (main.xabsl:13)\n"
            "main.xabsl:6:14: output symbol 'speed' is not registered, needed by option "
            "main (main.xabsl:13)\n"
            "main.xabsl:9:10: basic behavior 'walk' is not registered, needed by option "
            "main (main.xabsl:13)\n");
}

TEST(Linker, TellsWhatMayHaveBeenMeant) {
  Symbols symbols;
  symbols.input("ball.distanc", [] { return 1.0; });
  EXPECT_NE(linkErrors(symbols).find("did you mean 'ball.distanc'?"), std::string::npos);
}

TEST(Linker, TellsWrongTypes) {
  Symbols symbols = complete();
  symbols.input("ball.distance", [] { return true; });
  symbols.input("how", [] { return 1.0; });
  symbols.output("speed", [](Style) {});
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:3:13: input symbol 'ball.distance' is declared as float, but "
            "registered as bool, needed by option main (main.xabsl:12)\n"
            "main.xabsl:4:17: input symbol 'how' is declared as enum mode, but registered "
            "as float, needed by option main (main.xabsl:12)\n"
            "main.xabsl:6:14: output symbol 'speed' is declared as float, but registered "
            "as enum mode, needed by option main (main.xabsl:13)\n");
}

TEST(Linker, TellsWrongEnumerations) {
  Symbols symbols = complete();
  symbols.input("how", [] { return Other::a; });
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:4:17: input symbol 'how' is registered with an enumeration that is "
            "not, needed by option main (main.xabsl:12)\n");
  symbols.enumeration<Other>("other", {"a"});
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:4:17: input symbol 'how' is declared as enum mode, but registered "
            "as enum other, needed by option main (main.xabsl:12)\n");
  symbols = complete();
  symbols.enumeration<Style>("mode", {"slow", "fats"});
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:2:13: element 'fast' of enumeration 'mode' is not registered; did "
            "you mean 'fats'?\n");
}

TEST(Linker, TellsWrongParameters) {
  Symbols symbols = complete();
  symbols.input("scaled", {"value", "often"}, [](bool, bool) { return 1.0; });
  symbols.behavior("walk", {"x"}, [](double) {});
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:5:13: parameter 'often' of input symbol 'scaled' is registered, but "
            "not declared, needed by option main (main.xabsl:13)\n"
            "main.xabsl:5:26: parameter 'value' of input symbol 'scaled' is declared as "
            "float, but registered as bool, needed by option main (main.xabsl:13)\n"
            "main.xabsl:5:38: parameter 'twice' of input symbol 'scaled' is not "
            "registered, needed by option main (main.xabsl:13)\n"
            "main.xabsl:9:36: parameter 'style' of basic behavior 'walk' is not registered, "
            "needed by option main (main.xabsl:13)\n");
}

/// A basic behavior as in report H.5, which remembers something.
class Walk {
 public:
  double x = 0;
  Style style = Style::slow;
  int changes = 0;
  double way = 0;

  static constexpr const char* name = "walk";
  static constexpr auto parameters() {
    return std::tuple{parameter("style", &Walk::style), parameter("x", &Walk::x)};
  }
  void parametersChanged() { changes += style == Style::fast ? 10 : 1; }
  void execute() { way += x; }
};

TEST(Linker, TakesClassesAsBasicBehaviors) {
  Symbols symbols = complete();
  Walk walk;
  symbols.behavior(walk);
  EXPECT_EQ(linkErrors(symbols), "");
  double distance = 1;
  symbols.input("ball.distance", &distance);
  Engine::Creation creation = Engine::create(test::compiled(R"(namespace main("M") {
      enum mode { fast, slow };
      float input ball.distance;
      behavior walk { float x; enum mode style; }
    }
    option main { initial state s { action { walk(x = ball.distance, style = fast); } } }
    agent main("Main", main);)"),
                                             symbols);
  ASSERT_EQ(test::errors(creation.diagnostics), "");
  creation.engine->execute(0);
  creation.engine->execute(1);
  EXPECT_EQ(walk.style, Style::fast);
  EXPECT_EQ(walk.way, 2);
  EXPECT_EQ(walk.changes, 10);  // notified once, with the parameters in place
  ASSERT_TRUE(creation.engine->selectBehavior("walk"));
  EXPECT_TRUE(creation.engine->setParameter("x", "40"));
  creation.engine->execute(2);
  EXPECT_EQ(walk.way, 42);
  EXPECT_EQ(walk.style, Style::slow);
  EXPECT_EQ(walk.changes, 11);
}

/// Its parameters are not those that the behavior declares.
struct WrongWalk {
  bool x = false;
  double speed = 0;

  static constexpr const char* name = "walk";
  static constexpr auto parameters() {
    return std::tuple{parameter("x", &WrongWalk::x), parameter("speed", &WrongWalk::speed)};
  }
  void execute() {}
};

TEST(Linker, TellsWrongParametersOfClasses) {
  Symbols symbols = complete();
  WrongWalk walk;
  symbols.behavior(walk);
  EXPECT_EQ(linkErrors(symbols),
            "main.xabsl:9:10: parameter 'speed' of basic behavior 'walk' is registered, but "
            "not declared, needed by option main (main.xabsl:13)\n"
            "main.xabsl:9:23: parameter 'x' of basic behavior 'walk' is declared as float, "
            "but registered as bool, needed by option main (main.xabsl:13)\n"
            "main.xabsl:9:36: parameter 'style' of basic behavior 'walk' is not registered, "
            "needed by option main (main.xabsl:13)\n");
}

enum class NumberedGait { fast = 5, slow = 2 };

TEST(Linker, TakesEnumerationsWhoseValuesHaveGaps) {
  Symbols symbols;
  NumberedGait gait{};
  symbols.enumerationValues<NumberedGait>(
      "gait", {{NumberedGait::fast, "fast"}, {NumberedGait::slow, "slow"}});
  symbols.output("gait", &gait);
  for (const auto& [element, value] : std::vector<std::pair<std::string, NumberedGait>>{
           {"slow", NumberedGait::slow}, {"fast", NumberedGait::fast}}) {
    auto creation = Engine::create(
        test::compiled(
            "namespace s(\"S\") { enum gait output { slow, fast }; enum gait output gait; }"
            "option o { initial state s { action { gait = " +
            element +
            "; } } }"
            "agent a(\"A\", o);"),
        symbols);
    ASSERT_TRUE(creation.engine);
    creation.engine->execute(0);
    EXPECT_EQ(gait, value);
  }
}

}  // namespace
}  // namespace xabsl
