#include <chrono>
#include <fstream>

#include "base/File.h"
#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using TimeCommands = SessionTest;

TEST_F(TimeCommands, TimeGoesByInAnyUnit) {
  for (const auto& [line, ms] : {std::pair{"run 1", 1000},
                                 {"run 0.5 s", 1504},
                                 {"run 80 ms", 1584},
                                 {"run 2 steps", 1600},
                                 {"run 0.01 min", 2200},
                                 {"run 0.3s", 2504},
                                 {"run 80ms", 2584},
                                 {"step", 2592},
                                 {"step 3", 2616}}) {
    expectFine(line);
    EXPECT_EQ(session->time().ms, ms) << line;
  }
  expectError("run 1 year", "run", "expected: run TIME");
  expectError("run 3x", "x", "no unit of time");
  expectError("run -1", "-1", "is not from");
  expectError("step 1.5", "step", "expected");
}

TEST_F(TimeCommands, LiveSessionsGoOnUntilStopped) {
  using std::chrono::milliseconds;
  session->update(milliseconds{20});
  EXPECT_EQ(session->time().ms, 0);
  expectFine("start");
  session->update(milliseconds{100});
  const Time then = session->time();
  EXPECT_GT(then.ms, 0);
  expectFine("stop");
  session->update(milliseconds{20});
  EXPECT_EQ(session->time(), then);
  // At the pace of the clock.
  expectFine("st on 1");
  expectFine("start");
  const auto begin = std::chrono::steady_clock::now();
  while (session->time() < then + 160) session->update(milliseconds{20});
  EXPECT_GT(std::chrono::steady_clock::now() - begin, milliseconds{120});
}

TEST_F(TimeCommands, RunsAreInterruptedAndKeepEverything) {
  int steps = 0;
  const auto counting = session->afterSteps([&] {
    if (++steps == 10) session->interrupt();
  });
  expectError("run 1000", "run", "stopped at 0:00");
  EXPECT_EQ(session->time().ms, 80);
  expectFine("run 80ms");
  EXPECT_EQ(session->time().ms, 160);
  steps = 0;
  expectError("until ball.x > 3000", "until", "stopped at 0:00");
  EXPECT_FALSE(console->expectationFailed());
}

TEST_F(TimeCommands, ScriptsWaitAndExpect) {
  expectFine("place ball 0 0 500 0");
  expectFine("until ball.x > 200");
  EXPECT_GT(session->time().ms, 300);
  EXPECT_LT(session->time().ms, 1000);
  expectFine("expect ball.x > 200");
  EXPECT_FALSE(console->expectationFailed());
  expectError("until ball.x > 20000 within 0.1", "until", "did not come true");
  EXPECT_TRUE(console->expectationFailed());
  expectError("expect ball.x < 0", "expect", "does not hold");
  expectError("expect nothing", "nothing", "no such value");
}

TEST_F(TimeCommands, SameSeedSameSimulation) {
  expectFine("run 2");
  const auto before = session->simulation().fingerprint();
  expectFine("seed 5");
  EXPECT_EQ(session->time().ms, 0);
  expectFine("run 2");
  EXPECT_NE(session->simulation().fingerprint(), before);
  expectFine("seed 1");
  expectFine("run 2");
  EXPECT_EQ(session->simulation().fingerprint(), before);
  expectFine("reset");
  EXPECT_EQ(session->time().ms, 0);
  expectError("seed many", "many", "is no number");
  EXPECT_FALSE(console->execute("scene nothing"));
  EXPECT_EQ(session->robots().size(), 2u) << "a wrong scene changes nothing";
}

TEST_F(TimeCommands, LoadedStatesGoOnAsIfNothingHadHappened) {
  expectFine("robot red1");
  expectFine("set BehaviorControl.movement.maxForward 100");
  expectFine("run 1");
  expectFine("place ball -500 300 100 0");
  expectFine("robot red4");
  expectFine("sr BallLocator disabled");
  expectFine("run 1");
  expectFine("save " + file("a.state"));
  expectFine("run 1.2");
  const auto straight = session->simulation().fingerprint();
  expectFine("reset");
  expectFine("load " + file("a.state"));
  EXPECT_EQ(session->time().ms, 2000);
  expectFine("run 1.2");
  EXPECT_EQ(session->simulation().fingerprint(), straight);

  auto text = *readFile(file("a.state"));
  const std::size_t speed = text.find("100 0");
  ASSERT_NE(speed, text.npos);
  text[speed] = '2';
  ASSERT_TRUE(writeFile(file("b.state"), text));
  EXPECT_THAT(console->execute("load " + file("b.state")).error().what, HasSubstr("another way"));
  const std::size_t line = text.find("place ball");
  text.replace(line, 5, "run 9");
  ASSERT_TRUE(writeFile(file("c.state"), text));
  EXPECT_THAT(console->execute("load " + file("c.state")).error().what,
              HasSubstr("no command that changes"));
  ASSERT_TRUE(writeFile(file("d.state"), "{\"scene\": 3}"));
  EXPECT_FALSE(console->execute("load " + file("d.state")));
}

TEST_F(TimeCommands, RewindGoesBackAndOnAnotherWay) {
  expectFine("run 1");
  expectFine("place ball -500 300 100 0");
  expectFine("run 1");
  const auto middle = session->simulation().fingerprint();
  expectFine("place ball 700 0");
  expectFine("run 1");
  const auto end = session->simulation().fingerprint();
  expectFine("rewind 1.996s");
  EXPECT_EQ(session->time().ms, 1992) << "a tick ends then";
  expectFine("step");
  EXPECT_EQ(session->simulation().fingerprint(), middle);
  // What was done later is forgotten; done again, the same happens.
  expectFine("run 1");
  EXPECT_NE(session->simulation().fingerprint(), end);
  expectFine("rewind 2");
  expectFine("place ball 700 0");
  expectFine("run 1");
  EXPECT_EQ(session->simulation().fingerprint(), end);
  expectError("rewind 4", "4", "not past");
  expectFine("rewind 0");
  EXPECT_EQ(session->time().ms, 0);
}

TEST_F(TimeCommands, LosesImagesOnlyIfAskedTo) {
  expectFine("run 400 ms");
  EXPECT_EQ(session->match().robots()[0]->lostImages(), 0);
  expectFine("st off 100000");
  expectFine("run 400 ms");
  EXPECT_GT(session->match().robots()[0]->lostImages(), 5);
  expectFine("st on 2");
  EXPECT_EQ(session->pace().factor, 2);
  EXPECT_THAT(answers("st ?"), ElementsAre("st on 2"));
  expectFine("st on");
  EXPECT_THAT(answers("st ?"), ElementsAre("st on"));
  const auto lost = session->match().robots()[0]->lostImages();
  expectFine("run 400 ms");
  EXPECT_EQ(session->match().robots()[0]->lostImages(), lost);
  expectError("st maybe", "st", "expected");
}

TEST_F(TimeCommands, APaceThatIsNotReachedIsReportedOnce) {
  expectFine("st on 1000");
  screen.printed.clear();
  session->run([&] { return !screen.printed.empty(); });
  ASSERT_FALSE(screen.printed.empty());
  EXPECT_THAT(screen.printed.front(), HasSubstr("times as fast as real time, not 1000"));
  expectFine("run 80 ms");
  EXPECT_EQ(screen.printed.size(), 1u);
}

TEST_F(TimeCommands, BeginsAnewWithTheScenesScript) {
  const std::string scene = *readFile(session->options().scene);
  std::ofstream{file("own.con")} << "place ball 70 80\nrobot red4\n";
  std::ofstream{file("own.scene")} << "<scene script='own.con'" << scene.substr(6);
  expectFine("scene " + file("own.scene"));
  EXPECT_THAT(answers("get ball.x"), testing::ElementsAre("70"));
  expectFine("place ball 0 0");
  expectFine("robot all");
  expectFine("reset");
  EXPECT_THAT(answers("get ball.x"), testing::ElementsAre("70"));
  EXPECT_EQ(console->selection(), std::vector<std::string>{"red4"});
  expectFine("seed 3");
  EXPECT_THAT(answers("get ball.y"), testing::ElementsAre("80"));
}

}  // namespace
}  // namespace gt
