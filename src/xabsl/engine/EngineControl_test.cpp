#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using test::EngineTest;
using test::Mode;
using testing::ElementsAre;

// Debugging interfaces (report H.8)

TEST_F(EngineTest, RunsAnOptionAloneWithParameters) {
  load(R"(
    option main { initial state a { action { sub(speed = 1, how = fast); } } }
    option sub {
      float @speed; enum mode @how;
      initial state s { action { result = @speed; request = @how; } } })");
  EXPECT_THAT(pathAt(0), ElementsAre("main/a", "sub/s"));
  EXPECT_EQ(engine->root(), "main");
  ASSERT_TRUE(engine->selectRootOption("sub"));
  EXPECT_EQ(engine->root(), "sub");
  EXPECT_THAT(pathAt(1), ElementsAre("sub/s"));
  EXPECT_EQ(world.result, 0);  // not what main passed
  EXPECT_EQ(world.request, Mode::slow);
  EXPECT_TRUE(engine->setParameter("speed", "2.5"));
  EXPECT_TRUE(engine->setParameter("how", "fast"));
  EXPECT_FALSE(engine->setParameter("how", "turbo"));  // the behavior does not know it
  EXPECT_FALSE(engine->setParameter("speed", "2.5mm"));
  EXPECT_FALSE(engine->setParameter("nothing", "1"));
  EXPECT_FALSE(engine->selectRootOption("nothing"));
  engine->execute(2);
  EXPECT_EQ(world.result, 2.5);
  EXPECT_EQ(world.request, Mode::fast);
  ASSERT_TRUE(engine->selectAgent("main"));
  EXPECT_THAT(pathAt(3), ElementsAre("main/a", "sub/s"));
}

TEST_F(EngineTest, RunsABasicBehaviorAloneWithParameters) {
  load("option main { initial state a { action { stop(); } } }");
  ASSERT_TRUE(engine->selectBehavior("walk"));
  EXPECT_EQ(engine->root(), "walk");
  EXPECT_TRUE(engine->setParameter("speed", "70"));
  EXPECT_TRUE(engine->setParameter("speed", "70"));
  EXPECT_TRUE(engine->setParameter("careful", "true"));
  EXPECT_FALSE(engine->setParameter("careful", "1"));
  EXPECT_THAT(pathAt(0), ElementsAre("walk"));
  EXPECT_THAT(world.log, ElementsAre("walk 70 careful 0"));
  EXPECT_EQ(world.changes, 2);
  EXPECT_FALSE(engine->selectBehavior("main"));
}

TEST_F(EngineTest, SetsSymbolsByHand) {
  load("option main { initial state a { action { result = memory; } } }");
  EXPECT_TRUE(engine->setOutput("request", "slow"));
  EXPECT_EQ(world.request, Mode::slow);
  EXPECT_EQ(engine->symbol("request")->text, "slow");
  EXPECT_TRUE(engine->setOutput("memory", "-3"));
  EXPECT_FALSE(engine->setOutput("x", "1"));
  EXPECT_FALSE(engine->setOutput("flag", "yes"));
  engine->execute(0);
  EXPECT_EQ(world.result, -3);
}

// An edited behavior

TEST_F(EngineTest, GoesOnWithAnEditedBehavior) {
  load(R"(
    agent other("Other", main);
    option main {
      initial state a { decision { if (seen) goto b; else stay; } action { } }
      state b { action { memory = memory + 1; current = third; sub(); } } }
    option sub { initial state s { decision { goto t; } action { } } state t { action { } } })");
  ASSERT_TRUE(engine->selectAgent("other"));
  world.seen = true;
  engine->execute(100);
  engine->execute(130);
  engine->execute(160);
  const Engine before = std::move(*engine);
  load(R"(
    agent other("Other", main);
    option added { initial state s { action { } } }
    option main {
      state c { action { } }
      state b { action { result = memory; sub(); added(); } }
      initial state a { decision { if (seen) goto c; else stay; } action { } } }
    option sub { initial state u { action { } } state s { action { } } })");
  engine->resumeFrom(before);
  EXPECT_EQ(engine->selectedAgent(), "other");
  EXPECT_EQ(engine->symbol("current")->text, "third");
  engine->execute(190);
  EXPECT_EQ(world.result, 3);
  EXPECT_EQ(toString(engine->activations()),
            "main() 90 ms: b 90 ms\n"
            "  sub() 0 ms: u 0 ms\n"  // its state is gone
            "  added() 0 ms: s 0 ms\n");
}

TEST_F(EngineTest, GoesOnWithWhatAPersonChose) {
  load(R"(
    option main { initial state a { action { } } }
    option sub { float @speed; enum mode @how;
      initial state s { action { walk(speed = @speed, style = @how); } } })");
  ASSERT_TRUE(engine->selectRootOption("sub"));
  ASSERT_TRUE(engine->setParameter("speed", "2.5"));
  ASSERT_TRUE(engine->setParameter("how", "fast"));
  engine->cooperation().configure(3, 7);
  engine->execute(0);
  Engine before = std::move(*engine);
  EXPECT_EQ(world.changes, 1);
  load(R"(
    option main { initial state a { action { } } }
    option sub { enum mode @how; bool @new; float @speed;
      initial state s { action { walk(style = @how, speed = @speed, careful = @new); } } })");
  engine->resumeFrom(before);
  engine->execute(40);
  EXPECT_EQ(toString(engine->activations()),
            "sub(how = fast, new = false, speed = 2.5) 40 ms: s 40 ms\n"
            "  walk(speed = 2.5, careful = false, style = fast)\n");
  EXPECT_EQ(world.changes, 1);  // the basic behavior need not know
  EXPECT_EQ(engine->cooperation().message().priority, 3);
  EXPECT_EQ(engine->cooperation().synchronizationTicks(), 7);

  ASSERT_TRUE(engine->selectBehavior("walk"));
  ASSERT_TRUE(engine->setParameter("speed", "9"));
  before = std::move(*engine);
  load("option main { initial state a { action { walk(); } } }");
  engine->resumeFrom(before);
  world.log.clear();
  engine->execute(80);
  EXPECT_THAT(world.log, ElementsAre("walk 9 bold 0"));

  ASSERT_TRUE(before.selectRootOption("sub"));  // gone: on with the agent
  load("option main { initial state a { action { } } }");
  engine->resumeFrom(before);
  EXPECT_THAT(pathAt(120), ElementsAre("main/a"));
}

TEST_F(EngineTest, GoesOnWithTheSameBehaviorAsIfNothingHadHappened) {
  const std::string text = R"(option main {
    initial state a { decision { if (state_time >= 50) goto b; else stay; } action { } }
    state b { decision { if (state_time >= 30) goto a; else stay; } action { } } })";
  load(text);
  std::string straight;
  for (int i = 0; i < 20; ++i) {
    engine->execute(10 * i);
    straight += toString(engine->activations());
  }
  load(text);
  std::string reloaded;
  for (int i = 0; i < 20; ++i) {
    engine->execute(10 * i);
    reloaded += toString(engine->activations());
    const Engine before = std::move(*engine);
    load(text);
    engine->resumeFrom(before);
  }
  EXPECT_EQ(reloaded, straight);
}

// XABSL 2.1 (report H.7)

TEST_F(EngineTest, SetsOutputsOf21AfterTheGraph) {
  const Behavior text = test::compiled(test::declarations + R"(
    option main { initial state a { action { result = 1; stop(); result = 2; } } })");
  auto model = std::make_shared<Model>(text.model());
  model->dialect = Dialect::xabsl21;
  Engine::Creation creation = Engine::create(Behavior(model), world.symbols);
  ASSERT_TRUE(creation.engine);
  creation.engine->execute(0);
  EXPECT_THAT(world.log, ElementsAre("stop", "result 2"));
  load("option main { initial state a { action { result = 1; stop(); result = 2; } } }");
  world.log.clear();
  engine->execute(0);
  EXPECT_THAT(world.log, ElementsAre("result 1", "stop", "result 2"));
}

}  // namespace
}  // namespace xabsl
