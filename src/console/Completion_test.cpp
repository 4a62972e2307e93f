#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;

using CompletionTest = SessionTest;

TEST_F(CompletionTest, CompletesWhatIsTyped) {
  EXPECT_THAT(console->completions("x"), testing::ElementsAre("xbb", "xis", "xlb", "xo", "xos"));
  EXPECT_THAT(console->completions("dk send_self"), Contains("send_selfLocator_drawing"));
  EXPECT_THAT(console->completions("sr SelfLocator M"), testing::ElementsAre("MonteCarlo"));
  EXPECT_THAT(console->completions("xbb go_to_o"), testing::ElementsAre("go_to_own_goal"));
  EXPECT_THAT(console->completions("xis ball.seen.d"), testing::ElementsAre("ball.seen.distance"));
  EXPECT_THAT(console->completions("get red4.x"), testing::ElementsAre("red4.x"));
  EXPECT_THAT(console->completions("robot red"), testing::ElementsAre("red1", "red4"));
  EXPECT_THAT(console->completions("layout layouts/cm"),
              testing::ElementsAre("layouts/cmd.layout"));
  EXPECT_THAT(console->completions("layout cm"), testing::ElementsAre("cmd"));
  EXPECT_THAT(console->completions("nonsense \"open"), testing::IsEmpty());
  EXPECT_THAT(console->completions("hmr "), testing::IsEmpty());
  EXPECT_THAT(console->completions("dk ImageProcessor/percepts e"), testing::ElementsAre("every"));
  EXPECT_THAT(console->completions("gc k"), testing::ElementsAre("kickOff"));
  EXPECT_THAT(console->completions("gc kickOff r"), testing::ElementsAre("red"));
  EXPECT_THAT(console->completions("jbc 1 xo play_s"), testing::ElementsAre("play_soccer"));
  EXPECT_THAT(console->completions("jbc "), testing::IsEmpty());
  EXPECT_THAT(console->completions("until red4.x > 100 wi"), testing::ElementsAre("within"));
  EXPECT_THAT(console->completions("film start x fiel"), testing::ElementsAre("field"));
  EXPECT_THAT(console->completions("help vie"), testing::ElementsAre("view", "views"));
}

}  // namespace
}  // namespace gt
