#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestAllocations.h"
#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using test::EngineTest;
using test::Mode;
using test::World;
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
  engine->goOnFrom(before);
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
  engine->goOnFrom(before);
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
  engine->goOnFrom(before);
  world.log.clear();
  engine->execute(80);
  EXPECT_THAT(world.log, ElementsAre("walk 9 bold 0"));

  ASSERT_TRUE(before.selectRootOption("sub"));  // gone: on with the agent
  load("option main { initial state a { action { } } }");
  engine->goOnFrom(before);
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
    engine->goOnFrom(before);
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

// Cooperative states

/// Several robots that run one behavior and hear each other a cycle later.
class TeamTest : public testing::Test {
 protected:
  void start(std::size_t robots, const std::string& option, int ticks) {
    const Behavior behavior = test::compiled(test::declarations + option);
    for (std::size_t i = 0; i < robots; ++i) {
      worlds.push_back(std::make_unique<World>());
      Engine::Creation creation = Engine::create(behavior, worlds.back()->symbols);
      ASSERT_TRUE(creation.engine);
      engines.push_back(std::move(*creation.engine));
      engines.back().cooperation().configure(static_cast<double>(i), ticks);
    }
  }

  /// The state of each robot after so many more cycles.
  std::string after(int cycles) {
    for (; cycles > 0; --cycles) {
      std::vector<CooperationMessage> said;
      for (const Engine& engine : engines) said.push_back(engine.cooperation().message());
      for (std::size_t i = 0; i < engines.size(); ++i) {
        std::vector<CooperationMessage> heard = said;
        heard.erase(heard.begin() + static_cast<std::ptrdiff_t>(i));
        engines[i].cooperation().receive(heard);
        engines[i].execute(++now);
      }
    }
    std::string states;
    for (const Engine& engine : engines) states += engine.activations().front().state + " ";
    return states;
  }

  std::vector<std::unique_ptr<World>> worlds;
  std::vector<Engine> engines;
  std::int64_t now = 0;
};

const std::string attack = R"(
  option main {
    initial state wait { decision { if (seen) goto attack; else stay; } action { } }
    state attack capacity 1 {
      decision { if (conflict || !seen) goto wait; else stay; } action { } } })";

TEST_F(TeamTest, KeepsToTheCapacityOfAState) {
  start(3, attack, 2);
  worlds[0]->seen = worlds[1]->seen = true;
  EXPECT_EQ(after(2), "wait wait wait ");  // announced only
  EXPECT_EQ(after(1), "wait attack wait ");
  worlds[2]->seen = true;
  EXPECT_EQ(after(20), "wait attack wait ");
  worlds[1]->seen = false;
  EXPECT_EQ(after(20), "wait wait attack ");
}

TEST_F(TeamTest, PrefersTheLargestPriorityThenTheNext) {
  start(3, R"(
    option main {
      initial state wait { decision { if (seen) goto attack; else stay; } action { } }
      state attack capacity 2 { decision { if (seen) stay; else goto wait; } action { } } })",
        2);
  for (auto& world : worlds) world->seen = true;
  EXPECT_EQ(after(3), "wait wait attack ");
  EXPECT_EQ(after(1), "wait attack attack ");
  EXPECT_EQ(after(20), "wait attack attack ");
  worlds[2]->seen = false;
  EXPECT_EQ(after(3), "attack attack wait ");
}

TEST_F(TeamTest, LetsNoneOfEqualRivalsIn) {
  start(2, attack, 1);
  for (Engine& engine : engines) engine.cooperation().configure(5, 1);
  worlds[0]->seen = worlds[1]->seen = true;
  EXPECT_EQ(after(20), "wait wait ");
  engines[1].cooperation().configure(4, 1);
  EXPECT_EQ(after(3), "attack wait ");
}

TEST_F(TeamTest, SeesAConflict) {
  start(1, attack, 0);
  worlds[0]->seen = true;
  EXPECT_EQ(after(1), "attack ");
  CooperationMessage other = engines[0].cooperation().message();
  engines[0].cooperation().receive({other});
  engines[0].execute(++now);
  EXPECT_EQ(engines[0].activations().front().state, "wait");
}

TEST_F(TeamTest, EntersSynchronizedStatesTogether) {
  start(3, R"(
    option main {
      initial state wait { decision { if (seen) goto go; else stay; } action { } }
      state go synchronized 3 { action { } } })",
        2);
  worlds[0]->seen = worlds[2]->seen = true;
  EXPECT_EQ(after(20), "wait wait wait ");
  worlds[1]->seen = true;
  EXPECT_EQ(after(1), "wait wait wait ");
  EXPECT_EQ(after(1), "go wait go ");  // they have announced it for long
  EXPECT_EQ(after(1), "go go go ");
}

TEST_F(TeamTest, CountsTeammatesOnlyIfToldSo) {
  start(3, R"(
    option main {
      initial state wait { decision { if (seen) goto go; else stay; } action { } }
      state go synchronized 2 { action { } } }
    option other { initial state s { action { } } })",
        0);
  engines[2].selectRootOption("other");
  for (auto& world : worlds) world->seen = true;
  for (Engine& engine : engines) engine.cooperation().countTeammatesOnly(true);
  EXPECT_EQ(after(20), "wait wait s ");  // each has but one teammate in the option
  for (Engine& engine : engines) engine.cooperation().countTeammatesOnly(false);
  EXPECT_EQ(after(2), "go go s ");
}

TEST_F(TeamTest, AllocatesNothingToCooperate) {
  start(1, attack, 0);
  const std::vector<CooperationMessage> heard{{1, {}}, {2, {7, 7, 7, 7}}};
  engines[0].execute(0);
  const long before = test::allocations();
  for (int i = 1; i < 100; ++i) {
    worlds[0]->seen = i % 3 == 0;
    engines[0].cooperation().receive(heard);
    engines[0].execute(i);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace xabsl
