#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using WorldCommands = SessionTest;

TEST_F(WorldCommands, ThingsAreMovedByHand) {
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
  expectFine("press tailRight");
  expectFine("run 200 ms");
  EXPECT_TRUE(holds("RobotState.tailPan < -0.3 and abs(red1.RobotState.tailPan) < 0.05"));
  expectFine("press back off");
  expectFine("press tailRight off");
  expectFine("run 200 ms");
  EXPECT_TRUE(holds("RobotState.pressedFor.back == 0 and abs(RobotState.tailPan) < 0.05"));
  expectError("place nobody 0 0", "nobody", "no robot");
  expectError("place ball7 0 0", "ball7", "no such ball");
  expectError("place red4 0 99999", "99999", "is not from");
  expectError("throw red4 up", "throw", "expected");
  expectError("press nose", "press", "expected");
}

TEST_F(WorldCommands, WhoPutsIsToldWhatIsNotAsAsked) {
  EXPECT_THAT(answers("place red4 100 -200 90"), testing::IsEmpty());
  expectFine("run 1 s");
  // On a foreleg.
  EXPECT_THAT(answers("place ball 35 -140 4000 3000"),
              testing::ElementsAre(HasSubstr("ball: 35 -140 is taken; put at "),
                                   "ball: 5000 mm/s is too fast; it rolls with 3000 mm/s"));
  EXPECT_THAT(answers("set robots.blue1 100 -200"),
              testing::ElementsAre(HasSubstr("blue1: 100 -200 is taken; put at ")));
  EXPECT_THAT(answers("set robots.red1.radio true"), testing::IsEmpty());
  EXPECT_TRUE(holds("distance(blue1, red4) > 100"));
  expectFine("place ball 1000 500");
  expectFine("place red4 -600 0");
  EXPECT_TRUE(holds("blue1.x == 100 and blue1.y == -200")) << "its place is free now";
}

TEST_F(WorldCommands, TheFidelityChangesWhileTheSceneGoesOn) {
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

}  // namespace
}  // namespace gt
