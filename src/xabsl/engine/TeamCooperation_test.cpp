#include "xabsl/engine/TeamCooperation.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/TestAllocations.h"
#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestEngine.h"

namespace xabsl {
namespace {

using test::World;

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
  const long before = gt::allocations();
  for (int i = 1; i < 100; ++i) {
    worlds[0]->seen = i % 3 == 0;
    engines[0].cooperation().receive(heard);
    engines[0].execute(i);
  }
  EXPECT_EQ(gt::allocations(), before);
}

}  // namespace
}  // namespace xabsl
