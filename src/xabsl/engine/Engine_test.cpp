#include "xabsl/engine/Engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using test::EngineTest;
using test::Mode;
using testing::ElementsAre;

// The semantics of XABSL 3 engines, one test each.

TEST_F(EngineTest, StartsInTheInitialState) {
  load("option main { state a { action { } } initial state b { action { stop(); } } }");
  EXPECT_THAT(pathAt(0), ElementsAre("main/b", "stop"));
}

TEST_F(EngineTest, EvaluatesTheInitialStatesDecisionAtOnce) {
  load(R"(option main {
    initial state a { decision { if (x > 1) goto b; else stay; } action { } }
    state b { decision { goto a; } action { stop(); } } })");
  world.x = 2;
  EXPECT_THAT(pathAt(0), ElementsAre("main/b", "stop"));
}

TEST_F(EngineTest, MakesAtMostOneTransitionACycle) {
  load(R"(option main {
    initial state a { decision { goto b; } action { } }
    state b { decision { goto c; } action { } }
    state c { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/b"));
  EXPECT_THAT(pathAt(1), ElementsAre("main/c"));
  EXPECT_THAT(pathAt(2), ElementsAre("main/c"));
}

TEST_F(EngineTest, ReturnsToTheInitialStateAfterACycleOfInactivity) {
  load(R"(
    option main {
      initial state call { decision { if (seen) goto rest; else stay; } action { sub(); } }
      state rest { decision { if (seen) stay; else goto call; } action { } } }
    option sub {
      initial state a { decision { if (option_time > 0) goto b; else stay; } action { } }
      state b { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/call", "sub/a"));
  EXPECT_THAT(pathAt(1), ElementsAre("main/call", "sub/b"));
  world.seen = true;
  EXPECT_THAT(pathAt(2), ElementsAre("main/rest"));
  world.seen = false;
  EXPECT_THAT(pathAt(3), ElementsAre("main/call", "sub/a"));
  EXPECT_EQ(engine->activations()[1].optionTime, 0);
}

TEST_F(EngineTest, KeepsTheStateOfAnOptionThatAnotherCallerTakesOver) {
  load(R"(
    option main {
      initial state a { decision { if (seen) goto b; else stay; } action { sub(); } }
      state b { action { sub(); } } }
    option sub {
      initial state first { decision { if (option_time > 0) goto second; else stay; } action { } }
      state second { action { } } })");
  pathAt(0);
  EXPECT_THAT(pathAt(1), ElementsAre("main/a", "sub/second"));
  world.seen = true;
  EXPECT_THAT(pathAt(2), ElementsAre("main/b", "sub/second"));
}

TEST_F(EngineTest, MeasuresOptionTimeAndStateTime) {
  load(R"(option main {
    initial state a { decision { if (state_time >= 100) goto b; else goto a; } action { } }
    state b { action { result = state_time; memory = option_time; } } })");
  engine->execute(5000);
  EXPECT_EQ(engine->activations()[0].optionTime, 0);
  engine->execute(5060);  // going to the own state resets nothing
  EXPECT_EQ(engine->activations()[0].optionTime, 60);
  EXPECT_EQ(engine->activations()[0].stateTime, 60);
  engine->execute(5100);
  EXPECT_EQ(engine->activations()[0].state, "b");
  EXPECT_EQ(engine->activations()[0].optionTime, 100);
  EXPECT_EQ(engine->activations()[0].stateTime, 0);
  EXPECT_EQ(world.result, 0);
  engine->execute(5130);
  EXPECT_EQ(world.result, 30);
  EXPECT_EQ(engine->symbol("memory")->number, 130);
}

TEST_F(EngineTest, AsksTheCommonDecisionFirst) {
  load(R"(option main {
    common decision { if (x == 1) goto b; else if (x == 2) stay; }
    initial state a { decision { else goto c; } action { } }
    state b { decision { else if (x == 3) goto a; else stay; } action { } }
    state c { action { } } })");
  world.x = 1;
  EXPECT_THAT(pathAt(0), ElementsAre("main/b"));
  world.x = 2;
  EXPECT_THAT(pathAt(1), ElementsAre("main/b"));
  world.x = 3;
  EXPECT_THAT(pathAt(2), ElementsAre("main/a"));
  world.x = 2;
  EXPECT_THAT(pathAt(3), ElementsAre("main/a"));
  world.x = 0;
  EXPECT_THAT(pathAt(4), ElementsAre("main/c"));
}

TEST_F(EngineTest, RefersInTheCommonDecisionToTheCurrentState) {
  load(R"(option main {
    common decision { if (state_time >= 50) goto b; }
    initial state a { action { } }
    state b { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a"));
  EXPECT_THAT(pathAt(50), ElementsAre("main/b"));
  engine->execute(120);  // goes to the state that it is in: its time runs on
  EXPECT_EQ(engine->activations()[0].stateTime, 70);
}

TEST_F(EngineTest, RunsActionsInTheirOrderCommonOnesFirst) {
  load(R"(
    option main {
      common action { result = 1; }
      initial state a { action { sub(); result = 3; stop(); walk(speed = 4); } } }
    option sub { initial state s { action { result = 2; } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/s", "stop", "walk"));
  EXPECT_THAT(world.log, ElementsAre("result 1", "result 2", "result 3", "stop", "walk 4 bold 0"));
}

TEST_F(EngineTest, LetsLaterWritesToAnOutputWin) {
  load("option main { initial state a { action { result = 1; flag = true; result = 2; } } }");
  engine->execute(0);
  EXPECT_EQ(world.result, 2);
  EXPECT_TRUE(world.flag);
}

TEST_F(EngineTest, KnowsWhenASubOptionReachedATargetState) {
  load(R"(
    option main {
      initial state a { decision { if (action_done) goto b; else stay; } action { sub(); } }
      state b { decision { if (action_done) goto a; else stay; } action { stop(); } } }
    option sub {
      initial state work { decision { if (seen) goto done; else stay; } action { } }
      target state done { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/work"));
  world.seen = true;
  EXPECT_THAT(pathAt(1), ElementsAre("main/a", "sub/done"));
  EXPECT_TRUE(engine->activations()[1].target);
  EXPECT_THAT(pathAt(2), ElementsAre("main/b", "stop"));
  EXPECT_THAT(pathAt(3), ElementsAre("main/b", "stop"));  // its state calls no option
}

TEST_F(EngineTest, ForgetsATargetStateThatWasLeftCyclesAgo) {
  load(R"(
    option main {
      initial state a { decision { if (seen) goto b; else stay; } action { sub(); } }
      state b { decision { if (seen) stay; else goto c; } action { } }
      state c { decision { if (action_done) goto b; else stay; } action { sub(); } } }
    option sub { initial target state done { action { } } })");
  pathAt(0);
  world.seen = true;
  EXPECT_THAT(pathAt(1), ElementsAre("main/b"));
  world.seen = false;
  EXPECT_THAT(pathAt(2), ElementsAre("main/c", "sub/done"));
  EXPECT_THAT(pathAt(3), ElementsAre("main/b"));
}

TEST_F(EngineTest, IsDoneWhenAnyOfSeveralSubOptionsIs) {
  load(R"(
    option main {
      initial state a { decision { if (action_done) goto b; else stay; }
                        action { never(); stop(); sub(); } }
      state b { action { } } }
    option never { initial state s { action { } } }
    option sub {
      initial state s { decision { if (state_time >= 40) goto done; else stay; } action { } }
      target state done { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "never/s", "stop", "sub/s"));
  EXPECT_THAT(pathAt(40), ElementsAre("main/a", "never/s", "stop", "sub/done"));
  EXPECT_THAT(pathAt(80), ElementsAre("main/b"));
}

TEST_F(EngineTest, CountsOptionsOfCommonActionsForActionDone) {
  load(R"(
    option main {
      common action { sub(); }
      initial state a { decision { if (action_done) goto b; else stay; } action { } }
      state b { action { } } }
    option sub { initial target state done { action { } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/done"));
  EXPECT_THAT(pathAt(1), ElementsAre("main/b", "sub/done"));
}

TEST_F(EngineTest, PassesParametersBeforeTheCalleeRuns) {
  load(R"(
    option main { initial state a { action { sub(goal = x + 1, careful = seen, how = drive_mode); } } }
    option sub {
      float @goal [0..100] "mm";
      bool @careful;
      enum mode @how;
      initial state s {
        decision { if (@goal > 5) goto t; else stay; }
        action { walk(style = @how, speed = 2 * @goal, careful = @careful); } }
      state t { action { result = @goal; } } })");
  world.x = 3;
  world.seen = true;
  world.mode = Mode::fast;
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/s", "walk"));
  EXPECT_THAT(world.log, ElementsAre("walk 8 careful 1"));
  world.x = 6;
  EXPECT_THAT(pathAt(1), ElementsAre("main/a", "sub/t"));
  EXPECT_EQ(world.result, 7);
}

TEST_F(EngineTest, ResetsParametersThatAreNotPassed) {
  load(R"(
    option main {
      initial state a {
        decision { goto b; }
        action { } }
      state b {
        decision { if (seen) goto c; else stay; }
        action { sub(goal = 3, careful = true, how = fast); walk(speed = 3, careful = true, style = fast); } }
      state c { action { sub(); walk(); } } }
    option sub {
      float @goal; bool @careful; enum mode @how;
      initial state s { action { result = @goal; flag = @careful; request = @how; } } })");
  engine->execute(0);
  EXPECT_EQ(world.result, 3);
  EXPECT_TRUE(world.flag);
  EXPECT_EQ(world.request, Mode::fast);
  world.seen = true;
  world.log.clear();
  engine->execute(1);
  EXPECT_EQ(world.result, 0);
  EXPECT_FALSE(world.flag);
  EXPECT_EQ(world.request, Mode::slow);  // the first element in C++, not in XABSL
  EXPECT_THAT(world.log, ElementsAre("result 0", "walk 0 bold 0"));
}

TEST_F(EngineTest, TellsABasicBehaviorOnlyOfChangedParameters) {
  load("option main { initial state a { action { walk(speed = x); } } }");
  engine->execute(0);
  EXPECT_EQ(world.changes, 0);  // they start as 0, false and the first element
  world.x = 1;
  engine->execute(1);
  engine->execute(2);
  EXPECT_EQ(world.changes, 1);
  world.x = 0;
  engine->execute(3);
  EXPECT_EQ(world.changes, 2);
}

TEST_F(EngineTest, ShortCircuitsFromLeftToRight) {
  load(R"(option main { initial state a { decision {
    if (false && y > 0) stay; else if (true || y > 0) stay; else stay; } action { } } })");
  engine->execute(0);
  EXPECT_EQ(world.reads, 0);
  load(R"(option main { initial state a { decision {
    if (y > 0 && y > 1 && y > 2) stay; else stay; } action { } } })");
  world.y = 1;
  engine->execute(0);
  EXPECT_EQ(world.reads, 2);
}

TEST_F(EngineTest, ReadsInputsAtEachReference) {
  load("option main { initial state a { action { result = y + y; flag = y > 0; } } }");
  engine->execute(0);
  EXPECT_EQ(world.reads, 3);
}

TEST_F(EngineTest, DividesByZeroAsByAVerySmallNumberAndWarnsOnce) {
  load("option main { initial state a { action { result = 2 / x;\n memory = 7 % x; } } }");
  engine->execute(0);
  engine->execute(1);
  EXPECT_DOUBLE_EQ(world.result, 2 / 1e-7);
  EXPECT_EQ(engine->symbol("memory")->number, 0);
  ASSERT_EQ(engine->warnings().size(), 2u);
  EXPECT_THAT(toString(engine->warnings()[0]), testing::HasSubstr("warning: division by zero"));
  EXPECT_THAT(toString(engine->warnings()[1]),
              testing::HasSubstr("warning: remainder of a division by zero"));
  EXPECT_EQ(engine->warnings()[0].line + 1, engine->warnings()[1].line);
}

TEST_F(EngineTest, TakesRemaindersOfWholeParts) {
  EXPECT_EQ(value("7.9 % 4.2"), 3);
  EXPECT_EQ(value("-7.9 % 4.2"), -3);
  EXPECT_EQ(value("5 % 0.5"), 0);
  EXPECT_EQ(value("1e300 % 2"), 0);
}

TEST_F(EngineTest, ExecutesAnOptionTwiceInACycleAndWarnsOnce) {
  load(R"(
    option main { initial state a { action { sub(v = 1); sub(v = 2); stop(); stop(); } } }
    option sub {
      float @v;
      initial state s { decision { if (@v == 2) goto t; else stay; } action { walk(speed = @v); } }
      state t { action { walk(speed = @v); } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/s", "walk", "sub/t", "walk", "stop", "stop"));
  EXPECT_THAT(world.log, ElementsAre("walk 1 bold 0", "walk 2 bold 0", "stop", "stop"));
  EXPECT_EQ(engine->activations()[1].parameters[0].text, "1");
  EXPECT_EQ(engine->activations()[3].parameters[0].text, "2");
  EXPECT_THAT(pathAt(1), ElementsAre("main/a", "sub/t", "walk", "sub/t", "walk", "stop", "stop"));
  std::vector<std::string> texts;
  for (const Diagnostic& warning : engine->warnings()) texts.push_back(warning.message);
  EXPECT_THAT(texts, ElementsAre("option is executed more than once in a cycle",
                                 "basic behavior is executed more than once in a cycle",
                                 "basic behavior is executed more than once in a cycle"));
}

TEST_F(EngineTest, StartsInternalSymbolsWithTheirDefaults) {
  load(R"(option main { initial state a { action {
    result = memory; flag = was_seen; memory = memory + 1; was_seen = true; current = third; } } })");
  EXPECT_EQ(engine->symbol("current")->text, "first");
  engine->execute(0);
  EXPECT_EQ(world.result, 0);
  EXPECT_FALSE(world.flag);
  EXPECT_EQ(engine->symbol("current")->text, "third");
  engine->execute(1);
  EXPECT_EQ(world.result, 1);
  EXPECT_TRUE(world.flag);
}

TEST_F(EngineTest, ReadsBackTheLastValueOfAnOutput) {
  load(R"(option main { initial state a { action {
    result = result + 2; request = request == fast ? slow : fast; } } })");
  engine->execute(0);
  EXPECT_EQ(world.request, Mode::fast);
  engine->execute(1);
  EXPECT_EQ(world.result, 4);
  EXPECT_EQ(world.request, Mode::slow);
}

/// As in engines that compute `0 - x` and take remainders of whole numbers.
TEST_F(EngineTest, GivesZeroNoSign) {
  EXPECT_FALSE(std::signbit(value("-x")));
  EXPECT_FALSE(std::signbit(value("-0")));
  EXPECT_FALSE(std::signbit(value("(x - 7) % 7")));
  EXPECT_EQ(value("(x - 8) % 7"), -1);
  EXPECT_EQ(value("-(x + 2)"), -2);
}

}  // namespace
}  // namespace xabsl
