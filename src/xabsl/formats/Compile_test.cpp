#include "xabsl/formats/Compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using test::compiled;
using test::errors;
using test::errorsIn;
using testing::HasSubstr;

const std::string agentsText = R"(namespace main("Symbols") {
enum mode { fast, slow };
float input ball.distance "mm";
bool input ball.seen;
enum mode input how;
float input scaled(float value; enum mode by;);
float output speed;
bool output led;
enum mode output head;
float internal memory;
float const near = 150 "mm";
}
namespace main("Behaviors") { behavior walk { float x; enum mode how; } behavior stop { } behavior both { } }
option both { initial state s { action { } } }
option sub { float @v; bool @b; initial state s { action { } } }
agent main("Main", main);
)";
constexpr int symbolLines = 16;

/// The errors in a file whose option `main` has one state with these parts, in lines counted from
/// there.
std::string errorsInMain(const std::string& text) {
  const std::string all = errorsIn(agentsText + text);
  std::string result;
  std::size_t position = 0;
  while (position < all.size()) {
    const std::size_t end = all.find('\n', position);
    const std::string line = all.substr(position, end - position);
    const std::size_t number = line.find(':') + 1;
    const std::size_t rest = line.find(':', number);
    result +=
        std::to_string(std::stoi(line.substr(number)) - symbolLines) + line.substr(rest) + "\n";
    position = end + 1;
  }
  return result;
}

std::string errorsInDecision(const std::string& decision) {
  return errorsInMain("option main { initial state s { decision {\n" + decision +
                      "\n} action { } } }");
}
std::string errorsInAction(const std::string& action) {
  return errorsInMain("option main { initial state s { action {\n" + action + "\n} } }");
}
std::string errorsInValue(const std::string& value) {
  return errorsInAction("speed = " + value + ";");
}

// What the language allows

TEST(Compile, ResolvesAWholeBehavior) {
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

TEST(Compile, TakesAllFormsOfSymbols) {
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

TEST(Compile, TakesAllFormsOfOptionsAndStates) {
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

// Files

TEST(Compile, FollowsIncludesRelativeToTheIncludingFileAndEachOnce) {
  const VirtualFiles files = {
      {"a/agents.xabsl",
       "include \"options\\main.xabsl\"; include \"symbols.xabsl\"; agent m(\"M\", main);"},
      {"a/symbols.xabsl", "namespace symbols(\"S\") { float input x; }"},
      {"a/options/main.xabsl",
       "include \"../symbols.xabsl\"; include \"../agents.xabsl\";"
       "option main { initial state s { decision { if (x > 0) stay; else stay; } action { } } }"}};
  const Compilation compilation = compile("a/agents.xabsl", files);
  EXPECT_EQ(errors(compilation.diagnostics), "");
  EXPECT_TRUE(compilation.diagnostics.empty());
  ASSERT_TRUE(compilation.behavior);
  EXPECT_EQ(compilation.behavior->model().files.size(), 3u);
}

TEST(Compile, TellsWhichIncludeIsMissing) {
  const Compilation compilation = compile("a.xabsl", {{"a.xabsl", "\n  include \"b/c.xabsl\";"}});
  EXPECT_EQ(errors(compilation.diagnostics),
            "a.xabsl:2:11: cannot include 'b/c.xabsl': there is no such file\n");
  EXPECT_FALSE(compilation.behavior);
}

TEST(Compile, TellsThatAFileIsMissing) {
  EXPECT_EQ(errors(compile("/nowhere/agents.xabsl").diagnostics),
            "/nowhere/agents.xabsl: cannot open the file\n");
  EXPECT_EQ(errors(compile("/").diagnostics), "/: cannot open the file\n");
  EXPECT_EQ(errors(compile("/dev/zero").diagnostics), "/dev/zero: cannot open the file\n");
}

TEST(Compile, ReadsFilesFromDisk) {
  const std::filesystem::path folder = testing::TempDir() + "/xabsl_compile";
  std::filesystem::create_directories(folder / "options");
  std::ofstream(folder / "agents.xabsl")
      << "include \"options/main.xabsl\";\nagent main(\"Main\", main);\n";
  std::ofstream(folder / "options/main.xabsl") << "option main { initial state s { action { } } }";
  const Compilation compilation = compile((folder / "agents.xabsl").string());
  EXPECT_EQ(errors(compilation.diagnostics), "");
  EXPECT_TRUE(compilation.behavior);
  std::filesystem::remove_all(folder);
}

TEST(Compile, RefusesFilesThatAreTooLarge) {
  const Compilation compilation =
      compile("a.xabsl", {{"a.xabsl", std::string((2u << 20) + 1, ' ')}});
  EXPECT_EQ(errors(compilation.diagnostics), "a.xabsl: the file is larger than 2 MiB\n");
}

TEST(Compile, WarnsOfFilesWithAnotherName) {
  const Compilation compilation =
      compile("a.xabsl", {{"a.xabsl",
                           "option main { initial state s { action { } } }\n"
                           "agent m(\"M\", main);"}});
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_EQ(toString(compilation.diagnostics[0]),
            "a.xabsl:1:8: warning: option 'main' stands in a file of another name, expected "
            "'main.xabsl'");
  EXPECT_TRUE(compilation.behavior);
}

// Syntax errors

TEST(Compile, TellsWhatWasExpected) {
  EXPECT_EQ(errorsIn("42"),
            "main.xabsl:1:1: expected 'include', 'option', 'agent' or 'namespace', found "
            "'42'\n");
  EXPECT_EQ(errorsIn("include main;"),
            "main.xabsl:1:9: expected the path of a file in quotes, found 'main'\n");
  EXPECT_EQ(errorsIn("agent a(main);"),
            "main.xabsl:1:9: expected the title of the agent in quotes, found 'main'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { float x; }"),
            "main.xabsl:1:29: expected 'input', 'output' or 'internal', found 'x'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { enum e { a, }; }"),
            "main.xabsl:1:35: expected the name of an element, found '}'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { bool const b = 1; }"),
            "main.xabsl:1:28: constants are of type float\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { float output o(float x;); }"),
            "main.xabsl:1:37: only input symbols have parameters\n");
  EXPECT_EQ(errorsIn("option main { float x; }"),
            "main.xabsl:1:21: expected the name of a parameter, as in '@speed', found 'x'\n");
  EXPECT_EQ(errorsIn("option main { }"),
            "main.xabsl:1:15: expected a parameter, 'common' or a state, found '}'\n");
  EXPECT_EQ(errorsIn("option main { state s { decision { stay; } } }"),
            "main.xabsl:1:44: expected 'action', found '}'\n");
  EXPECT_EQ(errorsIn("option main"), "main.xabsl:1:12: expected '{', found the end of the file\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen) stay;"),
            "3:1: expected 'else', since each decision has an end ('else stay;'), found '}'\n");
  EXPECT_EQ(errorsInDecision("if ball.seen stay;"), "2:4: expected '(', found 'ball.seen'\n");
  EXPECT_EQ(errorsInDecision("go s;"), "2:1: expected 'if', 'goto', 'stay' or '{', found 'go'\n");
  EXPECT_EQ(errorsInAction("input = 1;"),
            "2:1: expected an action (an assignment, an option or a basic behavior) or '}', "
            "found the keyword 'input'\n");
  EXPECT_EQ(errorsInAction("speed;"), "2:6: expected '=' or '(', found ';'\n");
  EXPECT_EQ(errorsInAction("sub(1);"),
            "2:5: expected the name of a parameter, as in 'speed = 100', found '1'\n");
  EXPECT_EQ(errorsInAction("sub(v = 1 b = true);"), "2:11: expected ',' or ')', found 'b'\n");
  EXPECT_EQ(errorsInValue("1 +"), "2:12: expected an expression, found ';'\n");
  EXPECT_EQ(errorsInValue("1 < 2 < 3"), "2:15: comparisons cannot be chained, use '&&'\n");
  EXPECT_EQ(errorsInValue("true ? 1 : true ? 2 : 3"),
            "2:25: a '?:' inside another one needs parentheses\n");
}

TEST(Compile, TellsWhatBeginnersMeant) {
  EXPECT_EQ(errorsInDecision("if (how = fast) stay; else stay;"),
            "2:9: expected ')', found '='; did you mean '=='?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen & ball.seen) stay; elseif (true) stay;"),
            "2:15: unexpected character '&'; did you mean '&&'?\n"
            "2:34: expected 'else', since each decision has an end ('else stay;'), found "
            "'elseif'; did you mean 'else if'?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen and true) stay; else stay;"),
            "2:15: expected ')', found 'and'; did you mean '&&'?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen) stay; els stay;"),
            "2:22: expected 'else', since each decision has an end ('else stay;'), found "
            "'els'; did you mean 'else'?\n");
  EXPECT_EQ(errorsInDecision("goto sub;"),
            "2:6: unknown state 'sub' in option main; options are called by actions\n");
  EXPECT_EQ(errorsInAction("speed = 1,5;"),
            "2:10: expected ';', found ','; numbers are written with a point\n");
  EXPECT_EQ(errorsInAction("head = \"fast\";"),
            "2:8: expected an expression, found a string; elements of enumerations stand "
            "without quotes\n");
  EXPECT_EQ(errorsInAction("s();"),
            "2:1: unknown option or basic behavior 's' in option main; a state is entered by a "
            "decision\n");
  EXPECT_EQ(errorsInMain("option main { float @v; initial state s { action { speed = v; } } }"),
            "1:60: unknown input symbol 'v' in option main; did you mean '@v'?\n");
  EXPECT_EQ(errorsInMain("option main { initial state s { action { } decision { stay; } } }"),
            "1:44: the decision of a state stands before its action\n");
}

TEST(Compile, ReadsCooperation) {
  const Behavior behavior = test::compiled(
      "option main { initial state s capacity 2 { decision { if (conflict) goto t; else stay; }\n"
      "action { } } state t synchronized { action { } } state u synchronized 3 { action { } } }\n"
      "agent a(\"A\", main);");
  const std::vector<State>& states = behavior.model().states;
  EXPECT_EQ(states[0].cooperation.kind, Cooperation::Kind::capacity);
  EXPECT_EQ(states[0].cooperation.agents, 2);
  EXPECT_EQ(states[1].cooperation.kind, Cooperation::Kind::synchronized);
  EXPECT_EQ(states[1].cooperation.agents, 0);
  EXPECT_EQ(states[2].cooperation.agents, 3);
  EXPECT_EQ(errorsInMain("option main { initial state s capacity { action { } } }"),
            "1:40: expected the number of agents, found '{'\n");
  EXPECT_EQ(errorsInMain("option main { initial state s capacity 1.5 { action { } } }"),
            "1:40: the number of agents is a whole number up to 1000\n");
}

TEST(Compile, FindsSeveralSyntaxErrorsInOneRun) {
  EXPECT_EQ(errorsInMain("namespace main(\"M\") {\n float x;\n float input y;\n bool z;\n}\n"
                         "option main {\n initial state s { action { speed = ; led = 1 1; } }\n"
                         " state t { decision { goto; } action { } }\n state u { action { } } }\n"
                         "agent a(main);\nagent b(\"B\", main);\n"),
            "2:8: expected 'input', 'output' or 'internal', found 'x'\n"
            "4:7: expected 'input', 'output' or 'internal', found 'z'\n"
            "7:37: expected an expression, found ';'\n"
            "7:47: expected ';', found '1'\n"
            "8:27: expected the name of a state, found ';'\n"
            "10:9: expected the title of the agent in quotes, found 'main'\n");
}

// Errors of meaning

TEST(Compile, TellsUnknownNamesAndWhatWasMeant) {
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
  EXPECT_THAT(errorsIn("namespace main(\"M\") { enum nothing input x; }"),
              HasSubstr("main.xabsl:1:28: unknown enumeration 'nothing'\n"));
}

TEST(Compile, TellsWrongTypes) {
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

TEST(Compile, TellsWhatCannotBeDone) {
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

TEST(Compile, TellsWhatIsDeclaredTwice) {
  EXPECT_THAT(errorsIn("namespace main(\"M\") { float input x; bool input x; const y = 1;\n"
                       "bool output z; bool internal z; const y = 2; }"),
              HasSubstr("main.xabsl:1:49: input symbol 'x' is declared twice\n"
                        "main.xabsl:2:30: internal symbol 'z' is declared twice\n"
                        "main.xabsl:2:39: constant 'y' is declared twice\n"));
  EXPECT_THAT(errorsIn("namespace main(\"M\") { enum e { a, e.a }; enum e { b }; }"),
              HasSubstr("main.xabsl:1:35: element 'a' is declared twice\n"
                        "main.xabsl:1:47: enumeration 'e' is declared twice\n"));
  EXPECT_THAT(errorsIn("namespace main(\"M\") { behavior b { x; x; } behavior b { } }"),
              HasSubstr("main.xabsl:1:39: parameter 'x' is declared twice\n"
                        "main.xabsl:1:53: basic behavior 'b' is declared twice\n"));
  const std::string state = "initial state s { action { } } ";
  EXPECT_THAT(errorsIn("option main { " + state + "}\noption main { " + state + "}"),
              HasSubstr("main.xabsl:2:8: option 'main' is declared twice\n"));
  EXPECT_THAT(errorsIn("option main { " + state + "state s { action { } } }"),
              HasSubstr("main.xabsl:1:52: state 's' is declared twice in option main\n"));
  EXPECT_THAT(errorsIn("agent a(\"A\", b); agent a(\"A\", b);"),
              HasSubstr("main.xabsl:1:24: agent 'a' is declared twice\n"));
}

TEST(Compile, KeepsKindsOfSymbolsWithOneNameApart) {
  const std::string twins =
      "namespace main(\"M\") { float input x; float output x; float output y; bool input k; "
      "const k = 2; }\nagent a(\"A\", main); option main { initial state s { action {\n";
  test::compiled(twins + "x = x() + 1; } } }");
  EXPECT_EQ(errorsIn(twins + "y = x; } } }"),
            "main.xabsl:3:5: 'x' is an input symbol and an output symbol, expected 'x()' "
            "for the input in option main\n");
  EXPECT_EQ(errorsIn(twins + "y = k; } } }"),
            "main.xabsl:3:5: 'k' is a constant and an input symbol, expected 'k()' for the "
            "input in option main\n");
}

TEST(Compile, WantsExactlyOneInitialState) {
  EXPECT_EQ(errorsInMain("option main { state s { action { } } }"),
            "1:8: option main has no initial state, expected exactly one\n");
  EXPECT_EQ(errorsInMain("option main { initial state s { action { } } initial state t { action "
                         "{ } } }"),
            "1:60: option main has a second initial state, expected exactly one\n");
}

TEST(Compile, WantsElseIfAndOnlyIfThereIsACommonDecision) {
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

TEST(Compile, WantsAnAgent) {
  EXPECT_EQ(errorsIn("option main { initial state s { action { } } }"),
            "main.xabsl:1:1: there is no agent, expected 'agent name(\"title\", "
            "root_option);'\n");
}

TEST(Compile, TellsAtMostAHundredErrors) {
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
