#include "xabsl/language/Analyzer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using test::agentsText;
using test::compiled;
using test::errors;
using test::errorsIn;
using test::errorsInAction;
using test::errorsInDecision;
using test::errorsInMain;
using test::errorsInValue;
using testing::HasSubstr;

TEST(Analyzer, ResolvesAWholeBehavior) {
  const Model model = compiled(agentsText +
                               "option main { initial state s { action { walk(x = 1); } } "
                               "target state t { action { } } }")
                          .model();
  EXPECT_EQ(model.agents.size(), 1u);
  EXPECT_EQ(model.agents[0].name, "main");
  EXPECT_EQ(model.options[static_cast<std::size_t>(model.agents[0].rootOption)].name, "main");
  EXPECT_EQ(model.symbols.size(), 8u);
  EXPECT_EQ(model.behaviors.size(), 3u);
  EXPECT_TRUE(model.states.back().target);
  EXPECT_EQ(model.symbols[3].parameters[1].name, "by");
}

TEST(Analyzer, TakesAllFormsOfSymbols) {
  const Model model = compiled(R"(/*** Title: Test
      Platform: none
      Software-Environment: none */
    namespace main("Symbols") {
      /** What the robot does. */
      enum gesture input { gesture.none, kick };
      enum internal_enum internal { a }
      input untyped [0..1] "m";
      float input both "m" [0..1];
      enum gesture input current;
      float const pi = 3.14159 "rad";
      const e = -2.7e0;
      float input distance "mm" (
        /** The point. */
        float x [0..1] "mm";
        y "mm";
        bool exact;
      );
      internal z;
    }
    option main { initial state s { decision {
      if (current == none || current == gesture.kick) stay;
      else if (distance(x = pi, y = e, exact = true) > 1e3) stay;
      else stay; } action { z = current != gesture.none ? 1 : 0; } } }
    agent main("Main", main);)")
                          .model();
  EXPECT_EQ(model.enumerations[0].elements[0].name, "none");
  EXPECT_EQ(model.symbols[0].type.kind, ValueKind::number);
  EXPECT_EQ(model.symbols[3].parameters.size(), 3u);
}

TEST(Analyzer, TakesAllFormsOfOptionsAndStates) {
  const Model model = compiled(agentsText + R"(
    /** The main option. */
    option main {
      /** How far. */
      float @far [0..1] "m"; bool @b; enum mode @m; @untyped;
      common decision { /** near */ if (ball.seen && @b) { if (@far > 1) goto t; else stay; }
                        else if (@m == slow) goto s; }
      common action { head = fast; }
      initial target state s { decision { else { goto t; } } action { sub(); walk(); } }
      state t { decision { else if (true) stay; /** otherwise */ else stay; }
                action { both option(); both behavior(); sub(v = 1, b = true); } }
      target state u { action { head = @b ? slow : @m; } } })")
                          .model();
  EXPECT_EQ(model.options.back().states.count, 3);
}

TEST(Analyzer, TellsUnknownNamesAndWhatWasMeant) {
  EXPECT_EQ(errorsInValue("ball.disance"),
            "2:9: unknown input symbol 'ball.disance' in option main; did you mean "
            "'ball.distance'?\n");
  EXPECT_EQ(errorsInValue("somewhere"), "2:9: unknown input symbol 'somewhere' in option main\n");
  EXPECT_EQ(errorsInValue("@v"), "2:9: unknown parameter '@v' in option main\n");
  EXPECT_EQ(errorsInValue("scald(value = 1)"),
            "2:9: unknown input symbol 'scald' in option main; did you mean 'scaled'?\n");
  EXPECT_EQ(errorsInAction("sped = 1;"),
            "2:1: unknown output symbol 'sped' in option main; did you mean 'speed'?\n");
  EXPECT_EQ(errorsInAction("wlk();"),
            "2:1: unknown option or basic behavior 'wlk' in option main; did you mean "
            "'walk'?\n");
  EXPECT_EQ(errorsInAction("walk option();"), "2:1: unknown option 'walk' in option main\n");
  EXPECT_EQ(errorsInAction("sub behavior();"),
            "2:1: unknown basic behavior 'sub' in option main\n");
  EXPECT_EQ(errorsInAction("walk(y = 1);"),
            "2:6: basic behavior 'walk' has no parameter 'y' in option main\n");
  EXPECT_EQ(errorsInDecision("goto t;"), "2:6: unknown state 't' in option main\n");
  EXPECT_EQ(errorsInAction("head = sow;"),
            "2:8: enumeration 'mode' has no element 'sow', nor is there a symbol of that "
            "name in option main; did you mean 'slow'?\n");
  EXPECT_THAT(errorsIn("agent a(\"A\", nothing);"),
              HasSubstr("main.xabsl:1:14: unknown option 'nothing'\n"));
  EXPECT_THAT(errorsIn("namespace main(\"M\") { enum nothing input x; } agent a(\"A\", main);"),
              HasSubstr("main.xabsl:1:28: unknown enumeration 'nothing'\n"));
}

TEST(Analyzer, TellsWrongTypes) {
  EXPECT_EQ(errorsInValue("ball.seen"),
            "2:9: value of 'speed' must be float, found bool in option main\n");
  EXPECT_EQ(errorsInValue("how"),
            "2:9: value of 'speed' must be float, found enum mode in option main\n");
  EXPECT_EQ(errorsInValue("1 + true"),
            "2:13: operand of '+' must be float, found bool in option main\n");
  EXPECT_EQ(errorsInValue("-how"),
            "2:10: operand of '-' must be float, found enum mode in option main\n");
  EXPECT_EQ(errorsInAction("led = 1;"),
            "2:7: value of 'led' must be bool, found float in option main\n");
  EXPECT_EQ(errorsInAction("led = 1 && ball.seen;"),
            "2:7: operand of '&&' must be bool, found float in option main\n");
  EXPECT_EQ(errorsInAction("led = ball.seen == true;"),
            "2:17: '==' compares float or enum, found bool in option main; use '&&', "
            "'||' and '!'\n");
  EXPECT_EQ(errorsInAction("led = how == 1;"),
            "2:11: '==' compares enum mode with float in option main\n");
  EXPECT_EQ(errorsInAction("led = how < how;"),
            "2:7: operand of '<' must be float, found enum mode in option main\n"
            "2:13: operand of '<' must be float, found enum mode in option main\n");
  EXPECT_EQ(errorsInAction("led = true ? true : false;"),
            "2:12: '?:' chooses between float or enum, found bool in option main; use '&&' "
            "and '||'\n");
  EXPECT_EQ(errorsInValue("true ? 1 : how"),
            "2:14: '?:' chooses between float and enum mode in option main\n");
  EXPECT_EQ(errorsInValue("1 ? 1 : 2"),
            "2:9: condition of '?:' must be bool, found float in option main\n");
  EXPECT_EQ(errorsInDecision("if (1) stay; else stay;"),
            "2:5: condition must be bool, found float in option main\n");
  EXPECT_EQ(errorsInAction("walk(x = true);"),
            "2:10: parameter 'x' of basic behavior 'walk' must be float, found bool in "
            "option main\n");
}

TEST(Analyzer, TellsWhatCannotBeDone) {
  EXPECT_EQ(errorsInAction("ball.distance = 1;"),
            "2:1: input symbol 'ball.distance' cannot be set in option main\n");
  EXPECT_EQ(errorsInAction("walk(x = 1, x = 2);"),
            "2:13: parameter 'x' is set twice in option main\n");
  EXPECT_EQ(errorsInValue("near(x = 1)"),
            "2:9: 'near' is no input symbol and cannot have parameters in option main\n");
  EXPECT_EQ(errorsInAction("both();"),
            "2:1: 'both' is an option and a basic behavior, expected 'option' or "
            "'behavior' before '(' in option main\n");
}

TEST(Analyzer, TellsWhatIsDeclaredTwice) {
  EXPECT_THAT(errorsIn("namespace main(\"M\") { float input x; bool input x; const y = 1;\n"
                       "bool output z; bool internal z; const y = 2; } agent a(\"A\", main);"),
              HasSubstr("main.xabsl:1:49: input symbol 'x' is declared twice\n"
                        "main.xabsl:2:30: internal symbol 'z' is declared twice\n"
                        "main.xabsl:2:39: constant 'y' is declared twice\n"));
  EXPECT_THAT(
      errorsIn("namespace main(\"M\") { enum e { a, e.a }; enum e { b }; } agent a(\"A\", main);"),
      HasSubstr("main.xabsl:1:35: element 'a' is declared twice\n"
                "main.xabsl:1:47: enumeration 'e' is declared twice\n"));
  EXPECT_THAT(
      errorsIn(
          "namespace main(\"M\") { behavior b { x; x; } behavior b { } } agent a(\"A\", main);"),
      HasSubstr("main.xabsl:1:39: parameter 'x' is declared twice\n"
                "main.xabsl:1:53: basic behavior 'b' is declared twice\n"));
  const std::string state = "initial state s { action { } } ";
  EXPECT_THAT(
      errorsIn("option main { " + state + "}\noption main { " + state + "} agent a(\"A\", main);"),
      HasSubstr("main.xabsl:2:8: option 'main' is declared twice\n"));
  EXPECT_THAT(errorsIn("option main { " + state + "state s { action { } } } agent a(\"A\", main);"),
              HasSubstr("main.xabsl:1:52: state 's' is declared twice in option main\n"));
  EXPECT_THAT(errorsIn("agent a(\"A\", b); agent a(\"A\", b);"),
              HasSubstr("main.xabsl:1:24: agent 'a' is declared twice\n"));
}

TEST(Analyzer, KeepsKindsOfSymbolsWithOneNameApart) {
  const std::string twins =
      "namespace main(\"M\") { float input x; float output x; float output y; bool input k; "
      "const k = 2; }\nagent a(\"A\", main); option main { initial state s { action {\n";
  compiled(twins + "x = x() + 1; } } }");
  EXPECT_EQ(errorsIn(twins + "y = x; } } }"),
            "main.xabsl:3:5: 'x' is an input symbol and an output symbol, expected 'x()' "
            "for the input in option main\n");
  EXPECT_EQ(errorsIn(twins + "y = k; } } }"),
            "main.xabsl:3:5: 'k' is a constant and an input symbol, expected 'k()' for the "
            "input in option main\n");
}

TEST(Analyzer, WantsExactlyOneInitialState) {
  EXPECT_EQ(errorsInMain("option main { state s { action { } } }"),
            "1:8: option main has no initial state, expected exactly one\n");
  EXPECT_EQ(errorsInMain("option main { initial state s { action { } } initial state t { action "
                         "{ } } }"),
            "1:60: option main has a second initial state, expected exactly one\n");
}

TEST(Analyzer, WantsElseIfAndOnlyIfThereIsACommonDecision) {
  EXPECT_EQ(errorsInDecision("else stay;"),
            "2:1: unexpected 'else', since option main has no common decision\n");
  const Compilation compilation = compile(
      "main.xabsl",
      {{"main.xabsl", agentsText + "option main { common decision { if (ball.seen) stay; }\n"
                                   "initial state s { decision { stay; } action { } } }"}});
  EXPECT_TRUE(compilation.behavior);
  EXPECT_TRUE(std::any_of(compilation.diagnostics.begin(), compilation.diagnostics.end(),
                          [](const Diagnostic& one) {
                            return toString(one) ==
                                   "main.xabsl:18:30: warning: expected 'else', since option main "
                                   "has a common decision";
                          }));
  EXPECT_EQ(errorsInMain("option main { common decision { if (ball.seen) stay; else stay; }\n"
                         "initial state s { action { } } }"),
            "1:65: a common decision ends without an 'else'\n");
}

TEST(Analyzer, WantsAnAgent) {
  // Nothing of what stands in the other files of the behavior is an error besides.
  EXPECT_EQ(
      errorsIn(
          "option main { enum mode @m; initial state s { decision { if (x > 1) stay; else stay; } "
          "action { y = z; walk(); } } }"),
      "main.xabsl:1:1: there is no agent, expected 'agent name(\"title\", "
      "root_option);'\n");
}

TEST(Analyzer, TellsAnUnknownEnumerationWithoutWhatFollowsFromIt) {
  const auto errorsWith = [](const std::string& use) {
    return errorsIn(
        "namespace n(\"N\") { enum mode { fast, slow }; enum mode input how;\n"
        "enum mod output head; float input f(enum mode m;); }\n"
        "agent main(\"Main\", main); option main { initial state s {\n" +
        use + " } }");
  };
  const std::string unknown = "main.xabsl:2:6: unknown enumeration 'mod'; did you mean 'mode'?\n";
  for (const char* use :
       {"action { head = slow; }", "action { head = mod.slow; }", "action { head = how; }",
        "decision { if (head == slow) stay; else stay; } action { }",
        "decision { if (how == head) stay; else stay; } action { }",
        "action { head = f(m = head) > 1 ? slow : fast; }",
        "action { head = f() > 1 ? head : how; }"})
    EXPECT_EQ(errorsWith(use), unknown) << use;
  EXPECT_EQ(errorsWith("action { head = slow; how = slow; }"),
            unknown + "main.xabsl:4:23: input symbol 'how' cannot be set in option main\n");
}

TEST(Analyzer, TellsAtMostAHundredErrors) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "speed = unknown;\n";
  const Compilation compilation = compile(
      "main.xabsl",
      {{"main.xabsl", agentsText + "option main { initial state s { action {" + text + "} } }"}});
  const std::string all = errors(compilation.diagnostics);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 100);
  EXPECT_THAT(compilation.diagnostics.back().message, HasSubstr("no more are shown"));
}

}  // namespace
}  // namespace xabsl
