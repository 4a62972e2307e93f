#include <chrono>
#include <filesystem>
#include <thread>

#include "base/File.h"
#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

using TestCommands = SessionTest;

TEST_F(TestCommands, SituationsAreTriedManyTimes) {
  expectFine("place ball 0 0 900 0");
  expectFine("robot all");
  expectFine("ci off");
  const auto lines =
      answers("test situation 3 0.6 \"ball.x > 300\" \"ball.x < -300\" " + file("situation.csv"));
  EXPECT_THAT(lines, Contains(HasSubstr("ball.x > 300: 3 of 3")));
  EXPECT_EQ(session->time().ms, 0) << "this simulation is left alone";
  const auto csv = *readFile(file("situation.csv"));
  EXPECT_THAT(csv, HasSubstr("run,seed,result,seconds,red,blue,ballX,ballY\n1,1,ball.x > 300,0.3"));
  EXPECT_THAT(csv, HasSubstr("\n3,3,ball.x > 300,"));
  EXPECT_THAT(answers("test situation 2 0.1 \"ball.x > 2000\" " + file("none.csv")),
              Contains(HasSubstr("timeout: 2 of 2, after 0.1 s")));
  expectError("test situation 2 1 \"ball.x >\"", "the condition's end", "expected a value");
  expectError("test situation 2 1 nothing", "nothing", "no such value");
  expectError("test game many", "many", "is no number");
  expectError("test", "test", "expected");
}

/// As Ctrl-C does, after a while in which some have ended.
TEST_F(TestCommands, WhatEndedBeforeTheOthersWereStoppedIsKept) {
  const std::string table = file("stopped.csv");
  for (std::chrono::seconds wait{1}; wait < std::chrono::minutes{2}; wait *= 2) {
    const std::jthread signal{[&] {
      std::this_thread::sleep_for(wait);
      session->interrupt();
    }};
    const auto done = console->execute("test situation 100000 0.008 \"ball.x > 2000\" " + table);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().text(), HasSubstr("stopped"));
    if (std::filesystem::exists(table)) break;
  }
  EXPECT_THAT(*readFile(table), HasSubstr("\n1,1,timeout,0.008,"));
}

TEST_F(TestCommands, SituationsBeginWhereTheSimulationHasCome) {
  expectFine("place ball 0 0 900 0");
  expectFine("run 800 ms");
  expectFine("place blue1 1500 -600");
  ASSERT_TRUE(holds("ball.x > 500"));
  EXPECT_THAT(answers("test situation 2 1 \"ball.x > 500 and blue1.x == 1500\" \"ball.x < 500\" " +
                      file("begins.csv")),
              Contains(HasSubstr("blue1.x == 1500: 2 of 2, after 0.0 s")));
  EXPECT_THAT(answers("test situation 2 0.1 \"ball.x < 0\" " + file("none.csv")),
              Contains(HasSubstr("timeout: 2 of 2, after 0.1 s")));
}

TEST_F(TestCommands, SituationsAreSaved) {
  const std::string script = file("situation.con");
  expectFine("gc kickOff blue 1 2");
  expectFine("gc playing");
  expectFine("place red4 -600 200 90");
  expectFine("throw red4 left");
  expectFine("place blue1 1500 -300 45");
  expectFine("place ball 100 50 400 0");
  expectFine("test save " + script + " 1 \"ball.x > 200\"");
  expectFine("place ball -900 0");
  expectFine("stand red4");
  expectFine("run 400 ms");
  // The script begins anew, and takes time until its condition holds.
  expectFine("call " + script);
  EXPECT_LT(session->time().ms, 1000);
  EXPECT_TRUE(holds("ball.x > 200 and ball.x < 300 and score.red == 2 and score.blue == 1"));
  EXPECT_TRUE(holds("state == playing and kickOff == blue"));
  EXPECT_TRUE(holds("distance(red4, ball) < 1000 and abs(red4.y - 200) < 60"));
  EXPECT_EQ(value("red4.posture"), "onLeftSide");
  EXPECT_TRUE(holds("blue1.x == 1500 and blue1.rotation == 45"));
  // It fails if what is expected does not happen.
  expectFine("place ball 0 0");
  expectFine("test save " + script + " 0.2 \"ball.x > 2000\"");
  EXPECT_FALSE(console->execute("call " + script));
  expectError("test save " + script + " 0 \"ball.x > 2000\"", "0", "is not from");
  expectError("test save " + script + " 1 \"ball.x >\"", "the condition's end", "expected a value");
}

TEST_F(TestCommands, SolutionsAreComparedOnALog) {
  const std::string log = file("compared.mcap");
  expectFine("robot red1");
  expectFine("place red1 -600 0 0");
  expectFine("place ball 0 0");
  expectFine("log start");
  expectFine("run 120 ms");  // before head and legs follow, each its ball
  ASSERT_TRUE(holds("BallModel.lastSeen > 0")) << "nothing to compare";
  expectFine("log save " + log);
  const auto lines = answers("compare " + log + " BallLocator PIDSmoothed Probabilistic");
  EXPECT_THAT(lines, Contains(HasSubstr("BallModel: differs at ")));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("BallPercept: differs")))) << "it comes first";
  // The same computes the same.
  const auto same = answers("compare " + log + " BallLocator PIDSmoothed PIDSmoothed");
  ASSERT_EQ(same.size(), 1u) << same.front();
  EXPECT_THAT(same.front(), HasSubstr("are the same"));
  EXPECT_EQ(answers("compare " + log + " " + log).size(), 1u);
  expectError("compare " + log + " BallLocator Kalmann PIDSmoothed", "BallLocator", "Kalmann");
  EXPECT_FALSE(console->execute("compare no/such.mcap no/such.mcap"));
}

}  // namespace
}  // namespace gt
