#include "modules/modeling/robotstate/DefaultRobotStateDetector.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

struct Body {
  void run(BodyState perceived, std::int64_t ms) {
    body.state = perceived;
    for (std::int64_t t = 0; t < ms; t += 8) {
      frame.time = frame.time + 8;
      detector.update(body, frame, state);
    }
  }
  DefaultRobotStateDetector detector;
  BodyPercept body;
  FrameInfo frame;
  RobotState state;
};

TEST(DefaultRobotStateDetector, AFallCountsAfterTheSettleTime) {
  Body robot;
  robot.run(BodyState::standing, 1000);
  const Time fall = robot.frame.time + 8;
  robot.run(BodyState::fallen, 200);
  EXPECT_EQ(robot.state.state, BodyState::standing);
  robot.run(BodyState::fallen, 16);
  EXPECT_EQ(robot.state.state, BodyState::fallen);
  EXPECT_EQ(robot.state.lastChange, fall);
}

TEST(DefaultRobotStateDetector, AStumbleIsNoFall) {
  Body robot;
  for (int i = 0; i < 10; ++i) {
    robot.run(BodyState::standing, 100);
    robot.run(BodyState::fallen, 100);
    EXPECT_EQ(robot.state.state, BodyState::standing);
  }
  EXPECT_EQ(robot.state.lastChange, never());
}

TEST(DefaultRobotStateDetector, MeasuresHowLongASwitchIsPressed) {
  Body robot;
  robot.run(BodyState::standing, 80);
  EXPECT_EQ(robot.state.pressedFor[Switch::back], 0);
  robot.body.switches[Switch::back] = true;
  robot.run(BodyState::standing, 808);
  EXPECT_EQ(robot.state.pressedFor[Switch::back], 800);
  EXPECT_EQ(robot.state.pressedFor[Switch::chin], 0);
  robot.body.switches[Switch::back] = false;
  robot.run(BodyState::standing, 8);
  EXPECT_EQ(robot.state.pressedFor[Switch::back], 0);
  robot.body.switches[Switch::back] = true;
  robot.run(BodyState::standing, 16);
  EXPECT_EQ(robot.state.pressedFor[Switch::back], 8);
}

}  // namespace
}  // namespace gt
