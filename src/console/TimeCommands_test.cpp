#include "console/Condition.h"
#include "console/TestSession.h"
#include "streams/File.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class TimeCommands : public SessionTest {
 protected:
  bool holds(const std::string& text) {
    const auto condition = Condition::parse(text);
    EXPECT_TRUE(condition) << text << ": " << condition.error().text();
    const auto truth = condition->holds(*console);
    EXPECT_TRUE(truth) << text << ": " << truth.error().text();
    return *truth;
  }
  std::string value(const std::string& path) { return answers("get " + path).back(); }
};

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
  session->live(milliseconds{20});
  EXPECT_EQ(session->time().ms, 0);
  expectFine("start");
  session->live(milliseconds{100});
  const Time then = session->time();
  EXPECT_GT(then.ms, 0);
  expectFine("stop");
  session->live(milliseconds{20});
  EXPECT_EQ(session->time(), then);
  // At the pace of the clock.
  expectFine("st on 1");
  expectFine("start");
  const auto begin = std::chrono::steady_clock::now();
  while (session->time() < then + 160) session->live(milliseconds{20});
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

TEST_F(TimeCommands, ConditionsCompareWhatIsTrue) {
  EXPECT_TRUE(holds("1 + 2 * 3 == 7 and not 1 > 2"));
  EXPECT_TRUE(holds("(1 + 2) * 3 = 9 || 1 < 0"));
  EXPECT_TRUE(holds("2 - 1 - 1 == 0 && -min(1, 2) <= -1"));
  EXPECT_TRUE(holds("(max(abs(-3), 1) >= 3) != false"));
  EXPECT_TRUE(holds("ball.x == 200 and red4.x < 0 and score.red == 0"));
  EXPECT_TRUE(holds("state == playing and red1.posture != onLeftSide"));
  EXPECT_TRUE(holds("distance(red4, ball) == 800"));
  EXPECT_TRUE(holds("blue1.x > 1900 and ball.toucher == nobody"));
  EXPECT_TRUE(holds("red1.RobotPose.validity >= 0 and red1.ImageProcessor.denseSpacing == 2"));
  for (const char* wrong :
       {"", "1 +", "(1", "1 2", "a b", "f(1)", "1 < < 2", "distance(ball)", "§"})
    EXPECT_FALSE(Condition::parse(wrong)) << wrong;
  for (const char* wrong : {"nothing > 1", "state > 1", "state == 3", "distance(ball, 3) < 1",
                            "nothing == never", "red1.RobotPose.nothing > 1"}) {
    const auto condition = Condition::parse(wrong);
    ASSERT_TRUE(condition) << wrong;
    EXPECT_FALSE(condition->holds(*console)) << wrong;
  }
  std::string deep(1000, '('), longText = "1";
  for (int i = 0; i < 5000; ++i) longText += "+1";
  EXPECT_FALSE(Condition::parse(deep));
  EXPECT_FALSE(Condition::parse(longText));
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

TEST_F(TimeCommands, ThingsAreMovedByHand) {
  expectFine("place red4 100 -200 90");
  EXPECT_EQ(value("red4.x"), "100");
  EXPECT_TRUE(holds("red4.y == -200 and abs(red4.rotation - 90) < 0.001"));
  expectFine("place blue1 1500 0");
  EXPECT_TRUE(holds("blue1.x == 1500"));
  expectFine("throw red4 right");
  expectFine("run 1");
  EXPECT_EQ(value("red4.posture"), "onRightSide");
  expectFine("stand red4");
  expectFine("run 1");
  EXPECT_EQ(value("red4.posture"), "standing");
  expectFine("robot red4");
  expectFine("press back on");
  expectFine("run 200 ms");
  EXPECT_TRUE(holds("RobotState.pressedFor.back > 0 and red1.RobotState.pressedFor.back == 0"));
  expectFine("press back off");
  expectFine("run 200 ms");
  EXPECT_TRUE(holds("RobotState.pressedFor.back == 0"));
  expectError("place nobody 0 0", "nobody", "no robot");
  expectError("place ball7 0 0", "ball7", "no such ball");
  expectError("place red4 0 99999", "99999", "is not from");
  expectError("throw red4 up", "throw", "expected");
  expectError("press nose", "press", "expected");
}

TEST_F(TimeCommands, ObjectsAreListedWatchedAndMovedByPath) {
  EXPECT_THAT(
      answers("get ? robots.blue1"),
      Contains("robots.blue1 2000 0 0  // x y in mm, and the angle in deg; the robot is put on "
               "its feet there"));
  EXPECT_THAT(answers("get ? robots.blue1"), testing::Not(Contains(HasSubstr("red1"))));
  EXPECT_THAT(answers("get ?"), Contains(HasSubstr("robots.red1.sensors.psd")));
  EXPECT_THAT(answers("get RobotPose"), Contains(HasSubstr("red1: RobotPose.pose ")));
  EXPECT_THAT(answers("get ball"), Contains("ball.x 200"));
  expectError("get ball.speeed", "ball.speeed", "did you mean 'ball.speed'?");
  expectFine("set robots/blue1 500 100");
  EXPECT_EQ(value("robots/blue1"), "500 100 0");
  EXPECT_TRUE(holds("robots.blue1.1 == 100 and blue1.x == 500"));
  expectFine("set balls.0 -100 50 300 0");
  EXPECT_TRUE(holds("ball.speed == 300 and balls.0.2 == 300"));
  expectFine("set robots/red4/joints/headPan 40");
  EXPECT_TRUE(holds("abs(robots.red4.joints.headPan - 40) < 0.001"));
  expectFine("set radio/out true");
  EXPECT_EQ(value("radio/out"), "true");
  expectError("set robots/red9 0 0", "robots/red9", "no such object");
  expectError("set robots/red1/height 5", "robots/red1/height", "only be watched");
  expectError("set robots/red1 here", "robots/red1", "expected numbers");
  expectError("get robots/red9", "robots/red9", "no such value");
  EXPECT_THAT(console->completions("set robots.red1.po"),
              testing::ElementsAre("robots.red1.posture"));
  EXPECT_THAT(console->completions("get robots.red1.he"),
              testing::ElementsAre("robots.red1.height"));
  EXPECT_THAT(console->completions("set robots.red1.he"), testing::IsEmpty());
  for (const char* line : {"place ?", "throw ?", "stand ?"})
    EXPECT_THAT(answers(line), Contains("blue1")) << line;
  EXPECT_THAT(answers("place ?"), Contains("ball"));
  EXPECT_THAT(answers("press ?"), Contains("headFront"));
}

TEST_F(TimeCommands, TheFidelityChangesWhileTheSceneGoesOn) {
  EXPECT_EQ(answers("fidelity"), std::vector<std::string>{"kinematic"});
  EXPECT_EQ(answers("fidelity ?"), (std::vector<std::string>{"kinematic", "dynamic"}));
  expectFine("run 2");
  const double x = session->simulation().world().robot(1).pose.translation.x();
  EXPECT_THAT(answers("fidelity dynamic"), Contains(HasSubstr("motors, contacts and friction")));
  EXPECT_EQ(session->time().ms, 2000);
  EXPECT_NEAR(session->simulation().world().robot(1).pose.translation.x(), x, 1);
  EXPECT_THAT(answers("fidelity dynamic"), testing::IsEmpty());
  expectFine("run 1");
  EXPECT_TRUE(holds("fidelity == dynamic and red4.posture == standing"));
  expectFine("save " + file("dynamic.state"));
  expectFine("run 500 ms");
  const auto straight = session->simulation().fingerprint();
  expectFine("load " + file("dynamic.state"));
  EXPECT_TRUE(holds("fidelity == dynamic"));
  expectFine("run 500 ms");
  EXPECT_EQ(session->simulation().fingerprint(), straight);
  expectError("fidelity dreamlike", "fidelity", "expected");
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

TEST_F(TimeCommands, SituationsAreTriedManyTimes) {
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

}  // namespace
}  // namespace gt
