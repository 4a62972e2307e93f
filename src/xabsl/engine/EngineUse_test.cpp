#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "support/TestAllocations.h"
#include "xabsl/engine/Engine.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using test::EngineTest;
using test::Mode;
using test::World;
using testing::ElementsAre;

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

TEST_F(EngineTest, ReadsOperandsFromLeftToRight) {
  world.symbols.input("y", [this] { return world.x = world.x + 1; });
  const auto valueOf = [&](const std::string& expression) {
    world.x = 1;
    return value(expression);
  };
  EXPECT_EQ(valueOf("x - y"), 1 - 2);
  EXPECT_EQ(valueOf("y - x"), 2 - 2);
  EXPECT_EQ(valueOf("x - -(y)"), 1 + 2);
  EXPECT_EQ(valueOf("x * 10 + y * 100 + x * 1000"), 10 + 200 + 2000);
  EXPECT_EQ(valueOf("x < y ? 1 : 0"), 1);
  EXPECT_EQ(valueOf("y > x ? 1 : 0"), 0);
  EXPECT_EQ(valueOf("weighted(a = x, b = y)"), 12);
  EXPECT_EQ(valueOf("weighted(b = y, a = x)"), 12);  // as they are declared
}

/// Each is one of its size, the first three with values that their neighbors must not disturb.
struct Variables {
  float single = 0.5f;
  std::uint8_t byte = 200;
  std::int32_t integer = -7;
  std::int64_t large = 1'000'000'000'000;
  bool boolean = true;
  enum class Small : std::uint8_t { off, on } small = Small::on;
};

TEST(EngineVariables, AreReadWhateverTheirType) {
  Variables v;
  double sum = 0;
  bool flag = false;
  Symbols symbols;
  symbols.enumeration<Variables::Small>("small", {"off", "on"});
  symbols.input("single", &v.single);
  symbols.input("byte", &v.byte);
  symbols.input("integer", &v.integer);
  symbols.input("large", &v.large);
  symbols.input("boolean", &v.boolean);
  symbols.input("small.one", &v.small);
  symbols.output("sum", &sum);
  symbols.output("flag", &flag);
  Engine::Creation creation = Engine::create(test::compiled(R"(
      namespace all("All") {
        enum small { off, on };
        float input single; float input byte; float input integer; float input large;
        bool input boolean; enum small input small.one;
        float output sum; bool output flag;
      }
      option main { initial state s { action {
        sum = single + byte + integer + large; flag = boolean && small.one == on; } } }
      agent main("Main", main);)"),
                                             symbols);
  ASSERT_TRUE(creation.engine);
  creation.engine->execute(0);
  EXPECT_EQ(sum, 1'000'000'000'193.5);
  EXPECT_TRUE(flag);
  v.boolean = false;
  creation.engine->execute(1);
  EXPECT_FALSE(flag);
  v = {.boolean = true, .small = Variables::Small::off};
  creation.engine->execute(2);
  EXPECT_FALSE(flag);
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
  EXPECT_EQ(engine->symbol("weighted", {{"b", "3"}, {"a", "2"}})->number, 23);
  EXPECT_EQ(engine->symbol("weighted", {})->number, 0);
  EXPECT_EQ(engine->symbol("x", {})->number, 2.5);
  EXPECT_FALSE(engine->symbol("weighted", {{"c", "3"}}));
  EXPECT_FALSE(engine->symbol("weighted", {{"a", "true"}}));
  EXPECT_FALSE(engine->symbol("x", {{"a", "1"}}));
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
  const Behavior behavior = test::compiled(test::declarations + R"(option main {
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
    const Compilation next = compile("main.xabsl", {{"main.xabsl", test::declarations + text}});
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
  const long before = gt::allocations();
  for (int i = 0; i < 1000; ++i) engine->execute(10 * i);
  EXPECT_EQ(gt::allocations(), before);
  EXPECT_EQ(engine->warnings().size(), 4u);  // nothing of this was left out
}

}  // namespace
}  // namespace xabsl
