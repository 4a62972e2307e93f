#include "modules/motion/getup/GravityGetupEngine.h"

#include <gtest/gtest.h>

#include "modules/motion/testing/MotionHarness.h"

namespace gt {
namespace {

/// A robot that lies so that this is what it feels (mm/s^2), and shall get up.
struct Lying : MotionHarness {
  explicit Lying(const Vector3d& acceleration) {
    feel(acceleration);
    steps(100);
    request.type = MotionType::getup;
    steps(3);
  }
  void feel(const Vector3d& acceleration) { sensors.frames.back().acceleration = acceleration; }
};

TEST(GravityGetupEngine, ChoosesTheActionByWhereGravityPulls) {
  constexpr double g = 9810;
  const std::array<std::pair<Vector3d, std::string_view>, 8> cases{{
      {{0, -g, 0}, getupFromSide},
      {{0, g, 0}, getupFromSide},
      {{0.5 * g, 0.8 * g, -0.1 * g}, getupFromSide},
      {{0, 0.2 * g, -g}, getupFromBack},
      {{-0.4 * g, 0, -g}, getupFromBack},
      {{-0.8 * g, 0, 0.6 * g}, getupFromNose},
      {{0.7 * g, 0.1 * g, 0.7 * g}, getupFromBelly},
      {{0.1 * g, 0, g}, getupFromBelly},
  }};
  for (const auto& [acceleration, action] : cases) {
    Lying robot{acceleration};
    EXPECT_EQ(robot.info.executed.type, MotionType::getup);
    EXPECT_FALSE(robot.info.stable);
    EXPECT_EQ(robot.info.executed.specialAction, action) << acceleration.transpose();
  }
}

TEST(GravityGetupEngine, GoesOnFromActionToActionUntilItIsUpright) {
  Lying robot{{0, 0, -9810}};
  ASSERT_TRUE(robot.performs(getupFromBack));
  robot.feel({0, 9810, 0});
  const auto nextAction = [&] {
    const std::string before = robot.info.executed.specialAction;
    for (int i = 0; i < 1000 && robot.performs(before); ++i) robot.step();
    return robot.info.executed.specialAction;
  };
  EXPECT_EQ(nextAction(), getupFromSide);
  robot.feel({0, 0, 9810});
  EXPECT_EQ(nextAction(), "");
  robot.request = {};
  robot.step();
  EXPECT_NE(robot.info.executed.type, MotionType::getup);
}

TEST(GravityGetupEngine, EndsItsActionBeforeAnotherMotionBegins) {
  Lying robot{{0, 9810, 0}};
  robot.steps(20);
  robot.walk(100, 0, 0);
  robot.feel({0, 0, 9810});
  robot.steps(20);
  EXPECT_TRUE(robot.performs(getupFromSide));
  robot.steps(1000);
  EXPECT_EQ(robot.info.executed.type, MotionType::walk);
}

TEST(GravityGetupEngine, IsDeafToShocks) {
  Lying robot{{0, 0, 9810}};
  while (!robot.performs("")) robot.step();
  robot.feel({0, 30000, 0});
  robot.step();
  robot.feel({0, 0, 9810});
  robot.step();
  EXPECT_TRUE(robot.performs(""));
}

}  // namespace
}  // namespace gt
