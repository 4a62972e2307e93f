#include "console/TestSession.h"
#include "representations/motion/MotionInfo.h"

namespace gt {
namespace {

using GameCommands = SessionTest;

TEST_F(GameCommands, LeadsTheGame) {
  const Referee& referee = session->simulation().referee();
  expectFine("gc kickOff red 2 1");
  EXPECT_EQ(referee.state(), GameState::set);
  EXPECT_EQ(referee.score(TeamColor::blue), 2);
  EXPECT_EQ(referee.score(TeamColor::red), 1);
  EXPECT_EQ(referee.dataFor(0).kickOff, KickOff::own);
  expectFine("gc playing");
  EXPECT_EQ(referee.state(), GameState::playing);
  expectFine("robot red4");
  expectFine("pr obstruction");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::obstruction);
  EXPECT_EQ(referee.dataFor(0).penalty, Penalty::none);
  expectFine("pr continue");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::none);
  expectFine("pr ballHolding");
  expectFine("gc ready");
  EXPECT_EQ(referee.dataFor(1).penalty, Penalty::none) << "report J.2.6";
  expectFine("gc reset");
  EXPECT_EQ(referee.score(TeamColor::blue), 0);
  expectFine("gc final");
  EXPECT_EQ(referee.state(), GameState::finished);
  expectError("run 1", "run", "the game is over");
  expectError("gc kickOff green", "gc", "expected");
  expectError("gc kickOff red 1", "gc", "expected");
  expectError("pr nothing", "pr", "expected");
}

TEST_F(GameCommands, SlowsTheGameDown) {
  const auto speedAt = [&](const char* factor) {
    expectFine(std::string{"gs "} + factor);
    expectFine("run 2 s");
    return robot(0).provided<MotionInfo>()->executed.walk;
  };
  expectFine("sr BehaviorControl disabled");
  expectFine("mr normal 100 40 20");
  const Pose2D full = speedAt("1"), slow = speedAt("0.25");
  EXPECT_NEAR(full.translation.x(), 100, 1e-6);
  EXPECT_NEAR((slow.translation - full.translation / 4).norm(), 0, 1e-6);
  EXPECT_NEAR(slow.rotation, full.rotation, 0.02) << "turning is not slowed down";
  EXPECT_FALSE(console->execute("gs 0.05"));
}

}  // namespace
}  // namespace gt
