#include "console/TestSession.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using MotionCommands = SessionTest;

TEST_F(MotionCommands, MovesRobotsByHand) {
  expectFine("sr BehaviorControl disabled");
  expectFine("hcm none");
  expectFine("hmr -20 40 0 -10");
  expectFine("mr normal 100 0 0");
  expectFine("tr wagHorizontalFast");
  expectFine("run 2 s");
  EXPECT_NEAR(robot(0).provided<HeadMotionRequest>()->pan, fromDegrees(40), 1e-9);
  EXPECT_EQ(robot(0).provided<MotionInfo>()->executed.type, MotionType::walk);
  EXPECT_EQ(robot(0).provided<MotionRequest>()->tail, TailRequest::wagHorizontalFast);
  EXPECT_GT(session->simulation().world().robot(0).pose.translation.x(), -1950);
  expectFine("mr leftHeadKick");
  expectFine("run 200 ms");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->specialAction, "hookLeft");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->tail, TailRequest::wagHorizontalFast);
  EXPECT_THAT(answers("mr ?"), Contains("normal"));
  EXPECT_THAT(answers("tr ?"), Contains("noTailWag"));
  EXPECT_THAT(answers("hcm ?"), Contains("searchForLandmarks"));
  expectFine("hcm lookAtPoint 1000 -200 30");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<HeadControlMode>()->point, (Vector3d{1000, -200, 30}));
  expectFine("hcm lookAtPoint 1000 -200 30 20 130");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<HeadControlMode>()->pixel, (Vector2d{20, 130}));
  expectFine("hcm scanLeftRight -30 45");
  expectFine("run 100 ms");
  EXPECT_NEAR(robot(0).provided<HeadControlMode>()->scanRange, fromDegrees(45), 1e-9);
  expectFine("hcm lookAtPoint 1000 -200 30");
  EXPECT_THAT(answers("hmr 0 10 0 0"), Contains(HasSubstr("head control mode is lookAtPoint")));
  expectFine("hcm none");
  EXPECT_THAT(answers("hmr 0 10 0 0"), testing::IsEmpty());
  expectError("hcm lookAtPoint", "hcm", "expected");
  expectError("hcm lookAtPoint 1 2 3 4", "hcm", "expected");
  expectError("hcm scanLeftRight 1", "hcm", "expected");
  expectError("hcm searchForBall 1 2 3", "hcm", "expected");
  expectError("mr normal 1 2", "mr", "expected");
  expectError("mr fly", "fly", "no such motion");
  expectError("hmr 0 0 0 900", "900", "is not from");
  expectError("tr nod", "nod", "no such tail request");
  expectError("hcm nod", "nod", "no such head control mode");
  expectFine("sr BehaviorControl GT2003-soccer");
  EXPECT_EQ(answers("mr stand").size(), 2u) << "both robots are warned that the behavior decides";
}

}  // namespace
}  // namespace gt
