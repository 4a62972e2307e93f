#include "console/Condition.h"

#include "console/TestSession.h"

namespace gt {
namespace {

using ConditionTest = SessionTest;

TEST_F(ConditionTest, ConditionsCompareWhatIsTrue) {
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

}  // namespace
}  // namespace gt
