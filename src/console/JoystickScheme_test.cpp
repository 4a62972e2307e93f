#include "console/JoystickScheme.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

using Axis = Joystick::Axis;

JoystickScheme scheme(JoystickSchemeKind kind) {
  return {kind, {"push", "left", "right", "back"}, {"bow", "nod", "sit", "stand"}};
}

TEST(JoystickScheme, TheStickOfStickSpeedWalks) {
  auto joystick = scheme(JoystickSchemeKind::stickSpeed);
  EXPECT_EQ(joystick.motion().type, MotionType::stand);
  joystick.move(Axis::y, -1);
  joystick.move(Axis::x, 0.5);
  joystick.move(Axis::z, 0.01);  // not held
  EXPECT_EQ(joystick.motion().type, MotionType::walk);
  EXPECT_EQ(joystick.motion().walk.translation, Vector2d(200, -75));
  EXPECT_EQ(joystick.motion().walk.rotation, 0);
  joystick.press(8, true);
  joystick.press(8, false);
  EXPECT_EQ(joystick.motion().walkType, static_cast<WalkType>(1));
  for (std::size_t i = 1; i < enumCount<WalkType>; ++i) joystick.press(8, true);
  EXPECT_EQ(joystick.motion().walkType, WalkType::normal) << "after the last, the first";
}

TEST(JoystickScheme, ButtonsKickAndGetUp) {
  for (const auto kind : {JoystickSchemeKind::stickSpeed, JoystickSchemeKind::acceleratorSpeed}) {
    auto joystick = scheme(kind);
    joystick.press(3, true);
    EXPECT_EQ(joystick.motion().type, MotionType::specialAction);
    EXPECT_EQ(joystick.motion().specialAction, "right");
    joystick.press(7, true);
    EXPECT_EQ(joystick.motion().type, MotionType::getup);
    EXPECT_EQ(joystick.motion().specialAction, "");
    joystick.press(7, false);
    joystick.press(3, false);
    EXPECT_EQ(joystick.motion().type, MotionType::stand);
  }
}

TEST(JoystickScheme, MovesTheHeadInsteadOfTheLegsWhileAButtonIsHeld) {
  auto joystick = scheme(JoystickSchemeKind::stickSpeed);
  joystick.move(Axis::y, -1);
  EXPECT_EQ(joystick.headMode(), HeadMode::searchAuto);
  joystick.press(5, true);
  EXPECT_EQ(joystick.motion().type, MotionType::stand);
  EXPECT_EQ(joystick.headMode(), HeadMode::none);
  joystick.move(Axis::x, 0.5);
  EXPECT_NEAR(joystick.head().tilt, 0.7, 1e-9);
  EXPECT_NEAR(joystick.head().pan, -0.75, 1e-9);
  joystick.press(5, false);
  joystick.move(Axis::x, 1);
  EXPECT_NEAR(joystick.head().pan, -0.75, 1e-9) << "stays";
  EXPECT_EQ(joystick.headMode(), HeadMode::searchAuto);
  EXPECT_EQ(joystick.motion().type, MotionType::walk);
}

TEST(JoystickScheme, OnlyChangesAreTaken) {
  auto joystick = scheme(JoystickSchemeKind::stickSpeed);
  const auto taken = [&] {
    const auto changes = joystick.takeChanges();
    return std::array{changes.motion.has_value(), changes.headMode.has_value(),
                      changes.head.has_value()};
  };
  EXPECT_EQ(taken(), (std::array{false, false, false}));
  joystick.move(Axis::x, 0.5);
  EXPECT_EQ(taken(), (std::array{true, false, false}));
  EXPECT_EQ(taken(), (std::array{false, false, false}));
  joystick.press(5, true);
  EXPECT_EQ(taken(), (std::array{true, true, true}));
  joystick.move(Axis::x, 0.6);
  EXPECT_EQ(taken(), (std::array{false, false, true}));
  joystick.press(5, false);
  EXPECT_EQ(taken(), (std::array{true, true, false}));
  joystick.press(8, true);
  EXPECT_EQ(taken(), (std::array{true, false, false}));
  joystick.press(1, true);
  EXPECT_EQ(taken(), (std::array{true, false, false}));
}

TEST(JoystickScheme, TheLeverOfStickSpeedChoosesHeadControlModesOrActions) {
  auto joystick = scheme(JoystickSchemeKind::stickSpeed);
  joystick.move(Axis::accelerator, -1);
  EXPECT_EQ(joystick.headMode(), static_cast<HeadMode>(enumCount<HeadMode> - 1));
  joystick.move(Axis::accelerator, 1);
  EXPECT_EQ(joystick.headMode(), static_cast<HeadMode>(0));
  EXPECT_EQ(joystick.motion().type, MotionType::stand);
  joystick.press(6, true);
  EXPECT_EQ(joystick.motion().type, MotionType::stand) << "not before the lever is moved";
  joystick.move(Axis::accelerator, -0.1);
  EXPECT_EQ(joystick.motion().specialAction, "sit");
  joystick.move(Axis::accelerator, 0.9);
  EXPECT_EQ(joystick.motion().specialAction, "bow");
  EXPECT_EQ(joystick.headMode(), static_cast<HeadMode>(0));
  joystick.press(6, false);
  EXPECT_EQ(joystick.motion().type, MotionType::stand);
}

TEST(JoystickScheme, TheLeverOfAcceleratorSpeedWalksAhead) {
  auto joystick = scheme(JoystickSchemeKind::acceleratorSpeed);
  joystick.move(Axis::y, -1);
  EXPECT_EQ(joystick.motion().type, MotionType::stand) << "neither the stick nor an unmoved lever";
  joystick.move(Axis::accelerator, -0.5);
  joystick.move(Axis::z, -1);
  EXPECT_EQ(joystick.motion().walk.translation, Vector2d(150, 0));
  EXPECT_NEAR(joystick.motion().walk.rotation, 1.6, 1e-9);
  joystick.move(Axis::accelerator, 1);
  joystick.move(Axis::z, 0);
  EXPECT_EQ(joystick.motion().type, MotionType::stand);
  joystick.press(6, true);
  EXPECT_NE(joystick.motion().walkType, WalkType::normal);
  EXPECT_EQ(joystick.headMode(), HeadMode::searchAuto);
}

}  // namespace
}  // namespace gt
