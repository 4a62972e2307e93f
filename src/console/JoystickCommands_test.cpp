#include "console/TestSession.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {
namespace {

using ::testing::Contains;

using JoystickCommands = SessionTest;

TEST_F(JoystickCommands, FollowsAJoystick) {
  expectFine("sr BehaviorControl disabled");
  expectFine("jhc tilt");
  expectFine("jbc 1 mr headLeft");
  expectFine("jbc 32 echo a  b");
  EXPECT_THAT(answers("joystick press 32"), Contains("a  b"));
  expectFine("joystick release 32");
  expectFine("joystick press 1");
  expectFine("joystick y -1");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->specialAction, "headLeft")
      << "no walking while a button is pressed";
  expectFine("joystick release 1");
  expectFine("joystick accelerator -0.5");
  expectFine("run 100 ms");
  EXPECT_GT(robot(0).provided<MotionRequest>()->walk.translation.x(), 100);
  expectError("jbc 33 sit", "33", "is not from 1 to 32");
  expectError("jbc 1 fly", "fly", "no such command");
  expectError("jhc ear", "jhc", "expected");
}

}  // namespace
}  // namespace gt
