#include "console/TestSession.h"
#include "streams/File.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

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

}  // namespace
}  // namespace gt
