#include "xabsl/Engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/TestAllocations.h"
#include "xabsl/TestBehavior.h"

namespace xabsl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

enum class Mode { slow, fast, turbo };

/// A small world that every behavior of these tests shares: three inputs, three outputs, two basic
/// behaviors.
struct World {
  double x = 0;
  double y = 0;
  bool seen = false;
  Mode mode = Mode::slow;
  double result = -1;
  bool flag = false;
  Mode request = Mode::slow;
  std::vector<std::string> log;
  int reads = 0;
  int changes = 0;
  Symbols symbols;

  World() {
    symbols.enumeration<Mode>("mode", {"slow", "fast", "turbo"});
    symbols.input("x", &x);
    symbols.input("y", [this] {
      ++reads;
      return y;
    });
    symbols.input("seen", &seen);
    symbols.input("drive_mode", &mode);
    symbols.input("weighted", {"b", "a"}, [](double b, double a) { return 10 * a + b; });
    symbols.output("result", [this](double value) {
      result = value;
      log.push_back("result " + std::to_string(static_cast<int>(value)));
    });
    symbols.output("flag", &flag);
    symbols.output("request", [this](Mode value) { request = value; });
    symbols.behavior(
        "walk", {"speed", "careful", "style"},
        [this](double speed, bool careful, Mode style) {
          log.push_back("walk " + std::to_string(static_cast<int>(speed)) +
                        (careful ? " careful " : " bold ") +
                        std::to_string(static_cast<int>(style)));
        },
        [this] { ++changes; });
    symbols.behavior("stop", [this] { log.push_back("stop"); });
  }
};

const std::string declarations = R"(
  namespace main("Symbols") {
    enum mode { fast, slow };
    enum step { first, second, third };
    float input x;
    float input y [0..10] "mm";
    bool input seen;
    enum mode input drive_mode;
    float input weighted (float a; float b;);
    float output result;
    bool output flag;
    enum mode output request;
    float internal memory;
    bool internal was_seen;
    enum step internal current;
    float const limit = -2.5 "mm";
  }
  namespace main("Behaviors") {
    behavior walk { float speed [0..500] "mm/s"; bool careful; enum mode style; }
    behavior stop { }
  }
  agent main("Main", main);
)";

/// Runs the option `main` and those declared besides it.
class EngineTest : public testing::Test {
 protected:
  void load(const std::string& options) {
    Engine::Creation creation =
        Engine::create(test::compiled(declarations + options), world.symbols);
    ASSERT_EQ(test::errors(creation.diagnostics), "");
    engine.emplace(std::move(*creation.engine));
  }

  /// `option/state` and `behavior` of the last cycle.
  std::vector<std::string> path() const {
    std::vector<std::string> path;
    for (const Activation& activation : engine->activations())
      path.push_back(activation.name + (activation.state.empty() ? "" : "/" + activation.state));
    return path;
  }

  std::vector<std::string> pathAt(std::int64_t now) {
    engine->execute(now);
    return path();
  }

  /// The value of an expression of type float.
  double value(const std::string& expression) {
    load("option main { initial state s { action { result = " + expression + "; } } }");
    engine->execute(0);
    return world.result;
  }

  /// The value of a condition.
  bool holds(const std::string& condition) { return value(condition + " ? 1 : 0") != 0; }

  World world;
  std::optional<Engine> engine;
};

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
  EXPECT_THAT(world.log, ElementsAre("result 1", "result 2", "result 3", "stop", "walk 4 bold 1"));
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
        action { sub(goal = 3, careful = true, how = slow); walk(speed = 3, careful = true, style = slow); } }
      state c { action { sub(); walk(); } } }
    option sub {
      float @goal; bool @careful; enum mode @how;
      initial state s { action { result = @goal; flag = @careful; request = @how; } } })");
  engine->execute(0);
  EXPECT_EQ(world.result, 3);
  EXPECT_TRUE(world.flag);
  EXPECT_EQ(world.request, Mode::slow);
  world.seen = true;
  world.log.clear();
  engine->execute(1);
  EXPECT_EQ(world.result, 0);
  EXPECT_FALSE(world.flag);
  EXPECT_EQ(world.request, Mode::fast);  // the first element in XABSL, not in C++
  EXPECT_THAT(world.log, ElementsAre("result 0", "walk 0 bold 1"));
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
  EXPECT_THAT(world.log, ElementsAre("walk 1 bold 1", "walk 2 bold 1", "stop", "stop"));
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
  EXPECT_EQ(world.request, Mode::slow);
  engine->execute(1);
  EXPECT_EQ(world.result, 4);
  EXPECT_EQ(world.request, Mode::fast);
}

// Expressions

TEST_F(EngineTest, ComputesWithTheUsualPrecedence) {
  EXPECT_EQ(value("1 + 2 * 3 - 4 / 2"), 5);
  EXPECT_EQ(value("10 - 4 - 3"), 3);
  EXPECT_EQ(value("100 / 10 / 5"), 2);
  EXPECT_EQ(value("-(1 + 2) * --2"), -6);
  EXPECT_EQ(value("limit * 2"), -5);
  EXPECT_EQ(value("1 < 2 ? (2 > 3 ? 1 : 2) : 3"), 2);
  EXPECT_TRUE(holds("1 + 1 == 2 && 3 * 2 != 5"));
  EXPECT_TRUE(holds("true || false && false"));
  EXPECT_FALSE(holds("(true || false) && false"));
  EXPECT_TRUE(holds("!(1 > 2) && !false"));
  EXPECT_TRUE(holds("1 <= 1 && 1 >= 1 && !(1 < 1) && !(1 > 1)"));
}

TEST_F(EngineTest, ComparesEnumerationsByTheirNames) {
  world.mode = Mode::fast;
  EXPECT_TRUE(holds("drive_mode == fast"));
  EXPECT_TRUE(holds("drive_mode == mode.fast"));
  EXPECT_TRUE(holds("mode.fast == drive_mode"));
  EXPECT_TRUE(holds("drive_mode != slow"));
  EXPECT_TRUE(holds("(seen ? mode.slow : drive_mode) == fast"));
  world.mode = Mode::turbo;  // an element that the behavior does not know equals none
  EXPECT_FALSE(holds("drive_mode == fast || drive_mode == slow"));
}

TEST_F(EngineTest, CallsFunctionsWithParametersByName) {
  EXPECT_EQ(value("weighted(a = 1, b = 2)"), 12);
  EXPECT_EQ(value("weighted(b = 1, a = 2)"), 21);
  EXPECT_EQ(value("weighted(a = 3)"), 30);
  EXPECT_EQ(value("weighted(a = weighted(a = 1, b = 1), b = weighted(b = 4))"), 114);
}

// Debugging interfaces (report H.8)

TEST_F(EngineTest, ShowsTheActivationGraph) {
  load(R"(
    option main { initial state a { action { sub(speed = 1.5, how = slow); } } }
    option sub {
      float @speed; enum mode @how;
      initial target state s { action { walk(careful = true, style = @how, speed = @speed); } } })");
  engine->execute(100);
  engine->execute(150);
  EXPECT_EQ(toString(engine->activations()),
            "main() 50 ms: a 50 ms\n"
            "  sub(speed = 1.5, how = slow) 50 ms: s (target) 50 ms\n"
            "    walk(speed = 1.5, careful = true, style = slow)\n");
}

TEST_F(EngineTest, ReadsEverySymbolByName) {
  load("option main { initial state a { action { result = 4; } } }");
  world.x = 2.5;
  world.mode = Mode::fast;
  EXPECT_EQ(engine->symbol("x")->text, "2.5");
  EXPECT_EQ(engine->symbol("seen")->text, "false");
  EXPECT_EQ(engine->symbol("drive_mode")->text, "fast");
  engine->execute(0);
  EXPECT_EQ(engine->symbol("result")->number, 4);
  EXPECT_FALSE(engine->symbol("weighted"));  // a function has no value without parameters
  EXPECT_FALSE(engine->symbol("nothing"));
}

TEST_F(EngineTest, SelectsAgents) {
  load(R"(
    agent other("Other", other);
    option main { initial state a { action { } } }
    option other { initial state b { action { } } })");
  EXPECT_EQ(engine->selectedAgent(), "main");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a"));
  EXPECT_FALSE(engine->selectAgent("nobody"));
  EXPECT_TRUE(engine->selectAgent("other"));
  EXPECT_EQ(engine->selectedAgent(), "other");
  EXPECT_THAT(pathAt(1), ElementsAre("other/b"));
}

TEST_F(EngineTest, RunsAnyNumberOfInstancesOfOneBehavior) {
  const Behavior behavior = test::compiled(declarations + R"(option main {
    initial state a { decision { if (x > 0) goto b; else stay; } action { } }
    state b { action { } } })");
  World first;
  World second;
  Engine one = std::move(*Engine::create(behavior, first.symbols).engine);
  Engine two = std::move(*Engine::create(behavior, second.symbols).engine);
  first.x = 1;
  one.execute(0);
  two.execute(0);
  EXPECT_EQ(one.activations()[0].state, "b");
  EXPECT_EQ(two.activations()[0].state, "a");
}

TEST_F(EngineTest, KeepsTheOldBehaviorWhenANewOneHasErrors) {
  load("option main { initial state a { action { result = 1; } } }");
  const auto reload = [&](const std::string& text) {
    const Compilation next = compile("main.xabsl", {{"main.xabsl", declarations + text}});
    if (!next.behavior) return false;
    Engine::Creation creation = Engine::create(*next.behavior, world.symbols);
    if (creation.engine) engine = std::move(creation.engine);
    return true;
  };
  EXPECT_FALSE(reload("option main { initial state a { action { result = ; } } }"));
  engine->execute(0);
  EXPECT_EQ(world.result, 1);
  EXPECT_TRUE(reload("option main { initial state a { action { result = 2; } } }"));
  engine->execute(1);
  EXPECT_EQ(world.result, 2);
}

TEST_F(EngineTest, AllocatesNothingInACycle) {
  world.symbols.behavior("stop", [] {});
  world.symbols.output("result", &world.result);
  load(R"(
    option main {
      common action { flag = seen; }
      initial state a { decision { if (state_time > 20) goto b; else stay; }
                        action { sub(v = weighted(a = x, b = y)); sub(v = 2); } }
      state b { decision { if (action_done) goto a; else stay; } action { sub(v = 1 / x); } } }
    option sub {
      float @v;
      initial state s { decision { if (option_time > 50 && @v > 0) goto t; else stay; }
                        action { stop(); } }
      target state t { action { result = memory; memory = memory + @v % x; } } })");
  const long before = test::allocations();
  for (int i = 0; i < 1000; ++i) engine->execute(10 * i);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(engine->warnings().size(), 4u);  // nothing of this was left out
}

}  // namespace
}  // namespace xabsl
