#include "xabsl/tools/testing/TestRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "xabsl/tests/TestEngine.h"
#include "xabsl/tools/trace/TraceFile.h"

namespace xabsl {
namespace {

using testing::HasSubstr;

const std::string patrol = R"(
  agent lazy("Lazy", rest);
  option main {
    initial state search { decision { if (seen && weighted(a = y, b = x) > 20) goto approach; else stay; }
                           action { walk(speed = 10 + x, style = slow); } }
    state approach { decision { if (action_done) goto search; else stay; }
                     action { sub(goal = y); result = result + 1; } } }
  option sub {
    float @goal;
    initial state go { decision { if (state_time > 100) goto done; else stay; }
                       action { walk(speed = @goal); } }
    target state done { action { stop(); request = drive_mode; } } }
  option rest { initial state s { action { stop(); } } })";

const std::string head = R"(behavior "main.xabsl";
step 20;
function weighted(a, b) = 10 * a + b;
drive_mode = slow;
)";

/// `passed`, the errors, or the failure of the first test.
std::string outcome(const std::string& text, const std::string& before = head) {
  const std::string all = before + text;
  std::vector<Diagnostic> diagnostics;
  const TestFile file = parseTests("a.xtest", all, diagnostics);
  if (fails(diagnostics)) return test::errors(diagnostics);
  const TestResult result =
      runTest(test::compiled(test::declarations + patrol), file, file.tests.at(0));
  if (!result.errors.empty()) return test::errors(result.errors);
  return result.failure ? toString(*result.failure) : "passed";
}

TEST(TestRunner, RunsBehaviorsOnWrittenInputs) {
  EXPECT_EQ(outcome(R"(test "all" {
    x = 3;
    run;
    expect main == search && walk && walk.speed == 13 && walk.style == slow && !sub.active;
    expect time == 0;
    seen = true;
    y = time / 10;              // 2, 4
    until main == approach within 1000;
    expect main.previous == search && time == 40 && sub == go && sub.goal == y;
    expect result == 1;
    run 100 while sub == go && main == approach;
    run;
    expect sub == done && stop && !walk && request == slow && result == 7;
    run;
    expect main == search && !sub.active;
  })"),
            "passed");
}

TEST(TestRunner, TellsWhatDoesNotHoldAndWhere) {
  EXPECT_EQ(outcome("test \"t\" {\n  run;\n  expect main == approach;\n}"),
            "a.xtest:7:10: does not hold: main == approach");
  EXPECT_EQ(outcome("test \"t\" {\n  run 60 while y == 0;\n}"),
            "a.xtest:6:16: asks for a symbol that was neither read nor set: y == 0");
  EXPECT_EQ(outcome("test \"t\" {\n  until main == approach within 100;\n}"),
            "a.xtest:6:9: did not come true within time: main == approach");
  EXPECT_EQ(outcome("test \"t\" {\n x = time;\n  run 100 while time < 50;\n}"),
            "a.xtest:7:17: does not hold: time < 50");
}

TEST(TestRunner, TellsWrongFiles) {
  EXPECT_THAT(outcome("test \"t\" { x = ; }"), HasSubstr("5:16: expected an expression"));
  EXPECT_THAT(outcome("test \"t\" { run 5 }"), HasSubstr("expected ';'"));
  EXPECT_THAT(outcome("test \"t\" { frob; }"), HasSubstr("expected '='"));
  EXPECT_THAT(outcome("test \"t\" { zz = 1; }"), HasSubstr("5:12: unknown input symbol 'zz'\n"));
  EXPECT_THAT(outcome("test \"t\" { sene = 1; }"),
              HasSubstr("unknown input symbol 'sene'; did you mean 'seen'?"));
  EXPECT_THAT(outcome("test \"t\" { function weightd(a) = 1; }"),
              HasSubstr("unknown input symbol 'weightd'; did you mean 'weighted'?"));
  EXPECT_THAT(outcome("test \"t\" { weighted = 1; }"),
              HasSubstr("'weighted' has parameters, expected 'function weighted(a, b) = ...;'"));
  EXPECT_THAT(outcome("test \"t\" { function x(a) = 1; }"), HasSubstr("'x' has no parameters"));
  EXPECT_THAT(outcome("test \"t\" { result = 1; }"),
              HasSubstr("'result' is set by the behavior, expected an input symbol"));
  EXPECT_THAT(outcome("test \"t\" { seen = 1; }"), HasSubstr("5:19: "));
  EXPECT_THAT(outcome("test \"t\" { expect main == aproach; }"),
              HasSubstr("did you mean 'approach'"));
  EXPECT_THAT(outcome("test \"t\" { agent nobody; }"), HasSubstr("there is no agent 'nobody'"));
  EXPECT_THAT(outcome("test \"t\" { option sub(goal = true); }"), HasSubstr("cannot be true"));
  EXPECT_THAT(outcome("test \"t\" { replay \"nowhere.trace\"; }"), HasSubstr("nowhere.trace"));
  EXPECT_THAT(outcome("test \"t\" { function weighted(c) = 1; }"),
              HasSubstr("'weighted' has no parameter 'c', expected a, b"));
  EXPECT_THAT(outcome("test \"t\" { seen = true; run; }", "behavior \"main.xabsl\";"),
              HasSubstr("the behavior calls 'weighted', which needs a definition: function "
                        "weighted(a, b) = ...;"));
  EXPECT_THAT(outcome("", ""), HasSubstr("expected 'behavior \"PATH\";'"));
}

TEST(TestRunner, KnowsFunctionsOfNumbers) {
  const auto outcomeWith = [](const std::string& value, const std::string& before = "") {
    const std::string behavior =
        "namespace n(\"N\") { float input min(float a; float b;); float input max(float a; float "
        "b;); float input abs(float value;); float input sqrt(float a;);\n"
        "float input sin(float angle \"deg\";); float input cos(float angle;);\n"
        "float input atan2 \"deg\" (float x; float y;); float input x; float output result; }\n"
        "agent main(\"M\", main); option main { initial state s { action { result = " +
        value + "; } } }";
    const std::string text = "behavior \"main.xabsl\";\nx = -3;\n" + before +
                             "test \"t\" { run; expect result > 2.999999 && result < 3.000001; }";
    std::vector<Diagnostic> diagnostics;
    const TestFile file = parseTests("a.xtest", text, diagnostics);
    EXPECT_EQ(test::errors(diagnostics), "");
    const TestResult result = runTest(test::compiled(behavior), file, file.tests.at(0));
    return test::errors(result.errors) + (result.failure ? toString(*result.failure) : "");
  };
  EXPECT_EQ(outcomeWith("abs(value = x)"), "");
  EXPECT_EQ(outcomeWith("min(a = 3, b = 4) + min(a = 1, b = 0)"), "");
  EXPECT_EQ(outcomeWith("max(a = x, b = 3)"), "");
  EXPECT_EQ(outcomeWith("max(a = 3, b = x)"), "");
  EXPECT_EQ(outcomeWith("sqrt(a = 3 - 2 * x) + sqrt(a = x)"), "");
  // In the unit that the behavior declares; radians where it declares none.
  EXPECT_EQ(outcomeWith("6 * sin(angle = 30)"), "");
  EXPECT_EQ(outcomeWith("0 - 3 * cos(angle = 3.14159265358979)"), "");
  EXPECT_EQ(outcomeWith("atan2(y = 1, x = 0) / 30"), "");
  // A definition goes before.
  EXPECT_EQ(outcomeWith("abs(value = x)", "function abs(value) = 2 * value;\n"),
            "a.xtest:4:24: does not hold: result > 2.999999 && result < 3.000001");
}

TEST(TestRunner, SelectsAgentsAndOptionsWithParameters) {
  EXPECT_EQ(outcome("test \"t\" { agent lazy; run; expect rest == s && stop; }"), "passed");
  EXPECT_EQ(outcome("test \"t\" { option sub(goal = -2.5); run; expect walk.speed == -2.5; }"),
            "passed");
  EXPECT_EQ(outcome("test \"t\" { option walk(style = slow, speed = 3); run; "
                    "expect walk.style == slow && walk.speed == 3 && !main.active; }"),
            "passed");
}

TEST(TestRunner, RunsBehaviorsOnRecordedInputs) {
  // A recorded match: the elements have other values than in the test.
  test::World world;
  Engine engine =
      std::move(*Engine::create(test::compiled(test::declarations + patrol), world.symbols).engine);
  TraceRecorder recorder{10'000};
  engine.record(&recorder);
  world.mode = test::Mode::fast;
  world.seen = true;
  for (int i = 0; i < 20; ++i) {
    world.x = i;
    world.y = i < 5 ? 0 : 3;
    engine.execute(1000 + 30 * i);
  }
  const std::string path = testing::TempDir() + "recorded.trace";
  std::ofstream(path) << toText(TraceSubject::of(engine)) << toText(recorder.events());
  const std::string bare = "behavior \"main.xabsl\";\n";
  EXPECT_EQ(
      outcome("test \"t\" { replay \"" + path + "\" while result < 14; expect time == 570 && " +
                  "main == approach && sub == go && result == 13 && request == fast; }",
              bare),
      "passed");
  EXPECT_EQ(
      outcome("test \"t\" { replay \"" + path + "\" to 1120; expect walk.speed == 14; }", bare),
      "passed");
  EXPECT_THAT(outcome("test \"t\" { replay \"" + path + "\" from 9000; }", bare),
              HasSubstr("no cycle of that time"));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace xabsl
