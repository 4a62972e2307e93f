#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using ValueCommands = SessionTest;

TEST_F(ValueCommands, ReadsAndSetsParametersByPath) {
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red1: 2"));
  expectFine("set ImageProcessor.GT2003.denseSpacing 4");
  screen.printed.clear();
  expectFine("get ImageProcessor.GT2003.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red4: 4"));
  const auto tooLarge = console->execute("set ImageProcessor.denseSpacing 400");
  ASSERT_FALSE(tooLarge);
  screen.printed.clear();
  expectFine("get ImageProcessor.denseSpacing");
  EXPECT_THAT(screen.printed, Contains("red1: 4")) << "a wrong value changes nothing";
  EXPECT_FALSE(console->execute("set ImageProcessor.nonsense 4"));
  EXPECT_FALSE(console->execute("get nonsense"));
  screen.printed.clear();
  expectFine("get ?");
  EXPECT_GT(screen.printed.size(), 20u);
}

TEST_F(ValueCommands, ObjectsAreListedWatchedAndMovedByPath) {
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

TEST_F(ValueCommands, RobotsThatAreNamedHaveGroupsToo) {
  expectFine("run 200 ms");
  expectFine("robot red1");
  const auto selected = answers("get RobotPose");
  ASSERT_GT(selected.size(), 1u);
  EXPECT_EQ(answers("get red1.RobotPose"), selected);
  expectError("get red1.RobotPoses", "red1.RobotPoses", "no such value");
}

TEST_F(ValueCommands, SetsWhatItGetsOfANamedRobot) {
  expectFine("set red1.ImageProcessor.denseSpacing 4");
  EXPECT_EQ(value("red1.ImageProcessor.denseSpacing"), "4");
  EXPECT_EQ(value("red4.ImageProcessor.denseSpacing"), "2");
  expectFine("run 200 ms");
  expectFine("set red4.RobotPose.pose.translation.x 77");
  EXPECT_EQ(value("red4.RobotPose.pose.translation.x"), "77");
  EXPECT_NE(value("red1.RobotPose.pose.translation.x"), "77");
  expectError("set red1.Poet.rhyme 4", "Poet.rhyme", "there is no such value");
}

TEST_F(ValueCommands, RobotsOnLogsHaveNoBody) {
  expectFine("robot red1");
  expectFine("log start");
  expectFine("run 200 ms");
  expectFine("log save " + file("own.mcap"));
  expectFine("sl red9 " + file("own.mcap"));
  expectError("get red9.x", "red9.x", "red9 has no body");
  EXPECT_FALSE(console->execute("until red9.posture == standing"));
  expectFine("get red1.x");
}

}  // namespace
}  // namespace gt
