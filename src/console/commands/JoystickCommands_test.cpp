#include "console/TestSession.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/Joints.h"
#if __has_include(<SDL2/SDL.h>)
#include "support/VirtualJoystick.h"
#endif

namespace gt {
namespace {

using ::testing::Contains;

using JoystickCommands = SessionTest;

TEST_F(JoystickCommands, FollowsAJoystick) {
  expectFine("sr BehaviorControl disabled");
  expectFine("jhc tilt");
  expectFine("jbc 1 mr hookLeft");
  expectFine("jbc 32 echo a  b");
  EXPECT_THAT(answers("joystick press 32"), Contains("a  b"));
  expectFine("joystick release 32");
  expectFine("joystick press 1");
  expectFine("joystick y -1");
  expectFine("run 100 ms");
  EXPECT_EQ(robot(0).provided<MotionRequest>()->specialAction, "hookLeft")
      << "no walking while a button is pressed";
  expectFine("joystick release 1");
  expectFine("joystick accelerator -0.5");
  expectFine("run 100 ms");
  EXPECT_GT(robot(0).provided<MotionRequest>()->walk.translation.x(), 100);
  expectError("jbc 33 sit", "33", "is not from 1 to 32");
  expectError("jbc 1 fly", "fly", "no such command");
  expectError("jhc ear", "jhc", "expected");
}

TEST_F(JoystickCommands, MovesRobotsByASchemeOfTheReport) {
  const auto request = [&] { return *robot(0).provided<MotionRequest>(); };
  expectFine("sr BehaviorControl disabled");
  expectFine("joystick scheme stickSpeed");
  expectFine("joystick y -1 z -0.5");
  expectFine("run 100 ms");
  EXPECT_EQ(request().walk.translation, Vector2d(200, 0));
  EXPECT_NEAR(request().walk.rotation, 0.8, 1e-9);
  expectFine("joystick press 1");
  expectFine("run 100 ms");
  EXPECT_EQ(request().type, MotionType::specialAction);
  EXPECT_FALSE(request().specialAction.empty()) << "a kick of the table";
  expectFine("joystick release 1");
  expectFine("joystick press 5");
  expectFine("joystick x -1");
  expectFine("run 1500 ms");
  EXPECT_EQ(request().type, MotionType::stand);
  EXPECT_GT(robot(0).provided<JointData>()->angles[Joint::headPan], 1.4);
  expectFine("joystick release 5");
  expectFine("joystick scheme acceleratorSpeed");
  expectFine("joystick accelerator 0");
  expectFine("run 100 ms");
  EXPECT_EQ(request().walk.translation, Vector2d(100, 0));
  expectError("joystick scheme fast", "joystick", "expected");
  expectError("joystick on", "joystick", "none is plugged in");
  expectFine("joystick off");
}

#if __has_include(<SDL2/SDL.h>)
TEST_F(JoystickCommands, ThisMachinesJoystickSteersDuringARun) {
  VirtualJoystick joystick;
  expectFine("sr BehaviorControl disabled");
  expectFine("jbc 2 place ball 1234 0");
  expectFine("joystick on");
  SDL_JoystickSetVirtualButton(*joystick, 1, 1);
  expectFine("until ball.x == 1234 within 5");
  SDL_JoystickSetVirtualButton(*joystick, 1, 0);
  SDL_JoystickSetVirtualAxis(*joystick, 1, -32768);
  expectFine("until red1.walked > 100 within 20");
  // Released within the time in which no second command is sent, it stops nevertheless.
  SDL_JoystickSetVirtualAxis(*joystick, 1, -16000);
  expectFine("run 8 ms");
  SDL_JoystickSetVirtualAxis(*joystick, 1, 0);
  expectFine("until red1.MotionRequest.walk.translation.x == 0 within 5");
  expectFine("joystick off");
}
#endif

}  // namespace
}  // namespace gt
