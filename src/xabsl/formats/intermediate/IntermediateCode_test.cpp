#include "xabsl/formats/intermediate/IntermediateCode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <sstream>
#include <string>

#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using testing::HasSubstr;

std::string written(const Behavior& behavior, Dialect dialect = Dialect::xabsl31) {
  const IntermediateCode code = writeIntermediateCode(behavior.model(), dialect);
  EXPECT_EQ(test::errors(code.diagnostics), "");
  return code.text.value_or("");
}

/// The words of a text, each behind one blank.
std::string words(const std::string& text) {
  std::istringstream stream(text);
  std::string all;
  for (std::string word; stream >> word;) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// The words of the whole code of some options besides the common declarations, without the first
/// comment and without the agent.
std::string code(const std::string& options) {
  std::string text = words(written(test::compiled(test::declarations + options)));
  const std::string head = "// Intermediate code for the agents of ";
  EXPECT_EQ(text.substr(0, head.size()), head);
  text = text.substr(head.size());
  const std::string symbols = "0 3 e step current d memory b was_seen ";
  EXPECT_EQ(text.substr(0, symbols.size()), symbols);
  text = text.substr(symbols.size());
  const std::string agents = " 1 main main";
  EXPECT_EQ(text.substr(text.size() - agents.size()), agents);
  return text.substr(0, text.size() - agents.size());
}

std::string codeOfValue(const std::string& expression) {
  const std::string all =
      code("option main { initial state s { action { result = " + expression + "; } } }");
  const std::string head = "1 main 0 1 s n s 0 1 d result ";
  EXPECT_EQ(all.substr(0, head.size()), head);
  return all.substr(head.size(), all.size() - head.size() - std::string(" t s").size());
}

std::string codeOfCondition(const std::string& expression) {
  const std::string all = code("option main { initial state s { decision { if (" + expression +
                               ") stay; else stay; } action { } } }");
  const std::string head = "1 main 0 1 s n s 0 0 i ";
  EXPECT_EQ(all.substr(0, head.size()), head);
  return all.substr(head.size(), all.size() - head.size() - std::string(" t s t s").size());
}

std::string codeOfAction(const std::string& action) {
  const std::string all = code("option main { initial state s { action { " + action + " } } }");
  const std::string head = "1 main 0 1 s n s 0 ";
  EXPECT_EQ(all.substr(0, head.size()), head);
  return all.substr(head.size(), all.size() - head.size() - std::string(" t s").size());
}

TEST(IntermediateCode, HasTheLinesOfTheReferenceCompiler) {
  const Behavior behavior = test::compiled(
      "/*** Title: Example\n Platform: none */\n"
      "namespace n(\"N\") { float input x; bool internal done; enum e { a, b }; enum e input m;\n"
      "enum kind internal { good, bad }; behavior walk { x; } }\n"
      "option Run { float @v; enum e @m; initial state go { decision { if (x > 500) goto stop;\n"
      "else if (m == b) stay; else goto go; } action { walk(x = @v); } }\n"
      "target state stop capacity 2 { action { done = true; } } }\n"
      "option begin { initial state s { action { Run(v = 1.50); } } }\n"
      "agent one(\"One\", begin); agent two(\"Two\", Run);\n");
  EXPECT_EQ(written(behavior),
            "// Intermediate code for the agents of Example\r\n\r\n"
            "1\r\nkind 2 kind.good kind.bad\r\n1\r\nb done\r\n\r\n"
            "2\r\nbegin 0\r\nRun 2 d Run.v e e Run.m\r\n\r\n"
            "1\r\ns n\r\n\r\ns\r\n0\r\n1\r\no Run\r\n1\r\nd Run.v\r\nv 1.5\r\nt s\r\n\r\n\r\n\r\n"
            "2\r\ngo n\r\nstop c 2\r\n\r\ngo\r\n0\r\n1\r\na walk\r\n1\r\nd walk.x\r\np Run.v\r\n"
            "i\r\n>\r\ni x\r\n0\r\nv 500\r\nt stop\r\ni\r\nc\r\ni m\r\n0\r\nv e.b \r\nt go\r\n"
            "t go\r\n1\r\n1\r\nb done\r\nv true\r\nt stop\r\n\r\n\r\n\r\n"
            "2\r\none begin two Run\r\n");
}

TEST(IntermediateCode, WritesNumbersShort) {
  EXPECT_EQ(codeOfValue("500"), "v 500");
  EXPECT_EQ(codeOfValue("12.50"), "v 12.5");
  EXPECT_EQ(codeOfValue("3.0"), "v 3");
  EXPECT_EQ(codeOfValue("3."), "v 3");
  EXPECT_EQ(codeOfValue("-5"), "v -5");
  EXPECT_EQ(codeOfValue("-(-5.5)"), "v 5.5");
  EXPECT_EQ(codeOfValue("-0"), "v 0");
  EXPECT_EQ(codeOfValue("0.00001"), "v 1.0e-05");
  EXPECT_EQ(codeOfValue("1.5e3"), "v 1500");
  EXPECT_EQ(codeOfValue("limit"), "c -2.5");
}

TEST(IntermediateCode, WritesEveryNumericExpression) {
  EXPECT_EQ(codeOfValue("x + 1 - memory"), "- + i x 0 v 1 o memory");
  EXPECT_EQ(codeOfValue("x * 2 / y % 3"), "% d * i x 0 v 2 i y 0 v 3");
  EXPECT_EQ(codeOfValue("-x"), "- v 0 i x 0");
  EXPECT_EQ(codeOfValue("-limit"), "- v 0 c -2.5");
  EXPECT_EQ(codeOfValue("state_time + option_time"), "+ s t");
  EXPECT_EQ(codeOfValue("seen ? 1 : 2"), "q i seen 0 v 1 v 2");
  EXPECT_EQ(codeOfValue("result"), "o result");
  EXPECT_EQ(codeOfValue("weighted(b = 2, a = x)"),
            "i weighted 2 d weighted.b v 2 d weighted.a i x 0");
  EXPECT_EQ(codeOfValue("weighted(weighted.a = 1,)"), "i weighted 1 d weighted.a v 1");
}

TEST(IntermediateCode, WritesEveryCondition) {
  EXPECT_EQ(codeOfCondition("true"), "v true");
  EXPECT_EQ(codeOfCondition("!seen"), "! i seen 0");
  EXPECT_EQ(codeOfCondition("was_seen"), "o was_seen");
  EXPECT_EQ(codeOfCondition("action_done || conflict"), "| 2 t x");
  EXPECT_EQ(codeOfCondition("x == 1 && x != 2 && x < 3 && x <= 4 && x > 5 && x >= 6"),
            "& 6 = i x 0 v 1 n i x 0 v 2 < i x 0 v 3 l i x 0 v 4 > i x 0 v 5 g i x 0 v 6");
  EXPECT_EQ(codeOfCondition("seen && (flag && (was_seen && seen))"),
            "& 4 i seen 0 o flag o was_seen i seen 0");
  EXPECT_EQ(codeOfCondition("seen || flag && was_seen || (seen || flag)"),
            "| 4 i seen 0 & 2 o flag o was_seen i seen 0 o flag");
  EXPECT_EQ(codeOfCondition("drive_mode == slow"), "c i drive_mode 0 v mode.slow");
  EXPECT_EQ(codeOfCondition("request != mode.fast"), "! c o request v mode.fast");
}

TEST(IntermediateCode, WritesEveryAction) {
  EXPECT_EQ(codeOfAction("flag = seen; request = slow; current = seen ? second : third;"),
            "3 b flag i seen 0 e request v mode.slow e current q i seen 0 v step.second v "
            "step.third");
  EXPECT_EQ(codeOfAction("stop(); walk(style = slow, speed = 5);"),
            "2 a stop 0 a walk 2 e mode walk.style v mode.slow d walk.speed v 5");
}

TEST(IntermediateCode, CopiesWhatIsCommonIntoEachState) {
  EXPECT_EQ(code("option main { common decision { if (seen) goto b; else { if (flag) stay; } }\n"
                 "common action { result = 1; }\n"
                 "initial state a { decision { else if (x > 1) goto b; else stay; } action { } }\n"
                 "target state b synchronized { action { flag = true; } }\n"
                 "state c synchronized 3 { action { } } }"),
            "1 main 0 3 a n b s 0 c s 3 a "
            "0 1 d result v 1 i i seen 0 t b i o flag t a i > i x 0 v 1 t b t a "
            "1 2 d result v 1 b flag v true i i seen 0 t b i o flag t b t b "
            "0 1 d result v 1 i i seen 0 t b i o flag t c t c");
}

TEST(IntermediateCode, SaysWhatTheOldDialectCannot) {
  const Behavior plain = test::compiled(test::declarations +
                                        "option main { initial state a { action { } }\n"
                                        "state b { action { } } }");
  EXPECT_THAT(words(written(plain, Dialect::xabsl30)), HasSubstr("1 main 0 2 a b a 0 0 t a"));
  const Behavior cooperative = test::compiled(
      test::declarations +
      "option main { initial state a capacity 1 { decision { if (conflict) stay; else stay; }\n"
      "action { } } }");
  const IntermediateCode refused = writeIntermediateCode(cooperative.model(), Dialect::xabsl30);
  EXPECT_FALSE(refused.text);
  EXPECT_THAT(test::errors(refused.diagnostics),
              testing::AllOf(HasSubstr("cooperative state 'a' cannot be said"),
                             HasSubstr("'conflict' cannot be said")));
}

TEST(IntermediateCode, ListsDebugSymbols) {
  const Behavior behavior = test::compiled(
      "/*** Title: T */ namespace n(\"N\") { enum e { a, b }; enum e input m; float input x;\n"
      "bool output flag; behavior walk { float x; enum e how; } }\n"
      "option b { bool @v; initial state s { action { } } }\n"
      "option A { initial state s { action { b(v = true); } } } agent main(\"M\", A);");
  EXPECT_EQ(words(writeDebugSymbols(behavior.model())),
            "// Debug Symbols for the agents of T // number of enumerations 1 // "
            "enumerations // (name number-of-elements (element)*)+ e 2 e.a e.b // number "
            "of input symbols 2 // input symbols // (d decimal-input-symbol | b "
            "boolean-input-symbol | e enum-name enumerated-input-symbol)+ e e m d x // "
            "number of output symbols 1 // output symbols // (d decimal-output-symbol | b "
            "boolean-output-symbol | e enum-name enumerated-output-symbol)+ b flag // "
            "number of options 2 //options: (name num-of-parameters (d decimal-parameter "
            "| b boolean_parameter | e enum-name enumerated-parameter)*)+ A 0 b 1 b b.v "
            "// number of basic behaviors 1 //basic behaviors: (name num-of-parameters (d "
            "decimal-parameter | b boolean_parameter | e enum-name "
            "enumerated-parameter)*)+ walk 2 d walk.x e e walk.how");
}

/// Uses every construct of the language besides cooperation.
const std::string everything = test::declarations + R"(
  option sub {
    float @v [0..10] "mm"; bool @b; enum mode @m;
    common decision { if (@b && state_time > 40) goto done; else { if (@v > 80) goto begin; } }
    common action { memory = memory + 1; }
    initial state begin { decision { else if (@m == slow || @m != drive_mode) goto done; else stay; }
      action { walk(style = @m, speed = -@v); } }
    target state done { decision { else if (option_time > 100 && !(seen && flag)) goto begin; else goto done; }
      action { request = @m; flag = !@b; } }
  }
  option main {
    initial state first {
      decision {
        if (x > 50) { if (seen) goto second; else goto third; }
        else if (x / (y - 20) < limit && weighted(a = x % 7) >= 30) goto third;
        else stay;
      }
      action { sub(m = seen ? fast : drive_mode, v = x * 2 + y - 1.5); stop(); }
    }
    state second {
      decision { if (action_done || was_seen) goto third; else goto first; }
      action { sub(b = true, m = slow); was_seen = x == y; current = second; }
    }
    state third {
      decision { if (current == second && memory != 3 && request == drive_mode) goto first;
        else if (state_time <= 30) stay; else goto second; }
      action { result = state_time + memory; walk(style = fast); current = seen ? third : first; }
    }
  }
)";

/// What an engine does in a cycle, in words.
std::string cycle(Engine& engine, test::World& world, std::int64_t now) {
  world.log.clear();
  engine.execute(now);
  std::string text;
  for (const Activation& activation : engine.activations())
    text += activation.name + "/" + activation.state + " ";
  for (const std::string& entry : world.log) text += entry + ", ";
  return text + (world.flag ? "flag " : "") + std::to_string(static_cast<int>(world.request));
}

TEST(IntermediateCode, RunsAsTheTextDoes) {
  const Behavior text = test::compiled(everything);
  for (const Dialect dialect : {Dialect::xabsl31, Dialect::xabsl30}) {
    test::World worlds[2];
    const Compilation read =
        readIntermediateCode("a.dat", written(text, dialect), &worlds[1].symbols);
    ASSERT_EQ(test::errors(read.diagnostics), "");
    EXPECT_EQ(read.behavior->model().dialect, dialect);
    Engine::Creation one = Engine::create(text, worlds[0].symbols);
    Engine::Creation other = Engine::create(*read.behavior, worlds[1].symbols);
    ASSERT_EQ(test::errors(other.diagnostics), "");
    std::mt19937 random(20031);
    std::set<std::string> seen;
    for (int i = 0; i < 5000; ++i) {
      worlds[0].x = static_cast<double>(random() % 100);
      worlds[0].y = static_cast<double>(random() % 40);
      worlds[0].seen = random() % 3 == 0;
      worlds[0].mode = static_cast<test::Mode>(random() % 3);
      worlds[1].x = worlds[0].x;
      worlds[1].y = worlds[0].y;
      worlds[1].seen = worlds[0].seen;
      worlds[1].mode = worlds[0].mode;
      const std::string expected = cycle(*one.engine, worlds[0], i * 10);
      ASSERT_EQ(cycle(*other.engine, worlds[1], i * 10), expected) << "in cycle " << i;
      seen.insert(expected);
    }
    EXPECT_GT(seen.size(), 500u);  // the inputs make a difference
  }
}

TEST(IntermediateCode, IsTheSameAfterReading) {
  for (const Dialect dialect : {Dialect::xabsl31, Dialect::xabsl30}) {
    const std::string first = written(test::compiled(everything), dialect);
    const Compilation read = readIntermediateCode("a.dat", first);
    ASSERT_EQ(test::errors(read.diagnostics), "");
    // The title is a comment.
    EXPECT_EQ(words(written(*read.behavior, dialect)), words(first));
    test::World world;
    const Compilation completed = readIntermediateCode("a.dat", first, &world.symbols);
    ASSERT_EQ(test::errors(completed.diagnostics), "");
    EXPECT_EQ(words(written(*completed.behavior, dialect)), words(first));
  }
}

TEST(IntermediateCode, KeepsCooperationWhenRead) {
  const std::string first = written(
      test::compiled(test::declarations +
                     "option main { initial state a capacity 2 { decision { if (conflict) goto b;\n"
                     "else stay; } action { } } state b synchronized { action { } } }"));
  const Compilation read = readIntermediateCode("a.dat", first);
  ASSERT_EQ(test::errors(read.diagnostics), "");
  EXPECT_EQ(written(*read.behavior), first);
}

/// The errors in code with one option `main` of one state with these actions and this statement.
std::string errorsInCode(const std::string& body) {
  return test::errors(
      readIntermediateCode("a.dat", "0 0 1 main 1 d main.v 1 s n s 0 " + body + " 1 agent main")
          .diagnostics);
}

TEST(IntermediateCode, TellsWhatIsWrong) {
  EXPECT_EQ(errorsInCode("0 t s"), "");
  EXPECT_EQ(errorsInCode("0 t x"), "a.dat:1:37: unknown state 'x'\n");
  EXPECT_EQ(errorsInCode("0 y"), "a.dat:1:35: expected 't' or 'i', found 'y'\n");
  EXPECT_EQ(errorsInCode("1 z"),
            "a.dat:1:35: expected an action, 'o', 'a', 'd', 'b' or 'e', found 'z'\n");
  EXPECT_EQ(errorsInCode("1 o sub 0 t s"), "a.dat:1:37: unknown option 'sub'\n");
  EXPECT_EQ(errorsInCode("1 d out v x t s"), "a.dat:1:43: expected a number, found 'x'\n");
  EXPECT_EQ(errorsInCode("1 d out p main.w t s"),
            "a.dat:1:43: option 'main' has no parameter 'w'\n");
  EXPECT_EQ(errorsInCode("1 b out p main.v t s"),
            "a.dat:1:43: parameter 'v' is used with two types\n");
  EXPECT_EQ(errorsInCode("2 b out v true d out v 1 t s"),
            "a.dat:1:50: symbol 'out' is used with two types\n");
  EXPECT_EQ(errorsInCode("1 o main 0 t s"),
            "a.dat:1:35: options call one another in a cycle: main -> main\n");
  EXPECT_EQ(errorsInCode("999999999 t s"),
            "a.dat:1:33: expected the number of actions, found '999999999'\n");
  EXPECT_EQ(errorsInCode("0 " + std::string(1000, 'y')),
            "a.dat:1:35: expected 't' or 'i', found '" + std::string(80, 'y') + "...'\n");
  EXPECT_EQ(errorsInCode("0 t s 7"),
            "a.dat:1:43: expected the root option of agent '1', found 'agent'\n");
  EXPECT_EQ(test::errors(readIntermediateCode("a.dat", "").diagnostics),
            "a.dat:1:1: expected the number of internal enumerations, found the end of the "
            "file\n");
}

TEST(IntermediateCode, TakesOddNamesOfElementsAsTheyAre) {
  for (const std::string name : {"a.", "a.b.", ".a", "a", "a..b", "e.", "e.e.a"}) {
    const std::string first = "0 0 1 main 0 1 s n s 0 1 e out v " + name + " t s 1 agent main";
    const Compilation read = readIntermediateCode("a.dat", first);
    ASSERT_EQ(test::errors(read.diagnostics), "") << name;
    EXPECT_THAT(words(written(*read.behavior)), testing::EndsWith(first)) << name;
  }
}

TEST(IntermediateCode, EndsWithDeepCodeInBoundedTime) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "! ";
  EXPECT_THAT(errorsInCode("1 b out " + deep + "v true t s"), HasSubstr("nested too deeply"));
  std::string chain;
  for (int i = 0; i < 20'000; ++i) chain += "i v true t s ";
  EXPECT_EQ(errorsInCode("0 " + chain + "t s"), "");
}

}  // namespace
}  // namespace xabsl
