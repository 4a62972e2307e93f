#include "devices/SdlJoystick.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/VirtualJoystick.h"

namespace gt {
namespace {

using Part = SdlJoystick::Part;

TEST(SdlJoystick, ReportsWhatIsMoved) {
  VirtualJoystick device;
  auto opened = SdlJoystick::open();
  ASSERT_TRUE(opened) << opened.error().text();
  SdlJoystick& joystick = **opened;
  joystick.take();
  SDL_JoystickSetVirtualAxis(*device, 1, -32768);
  SDL_JoystickSetVirtualButton(*device, 6, 1);
  SDL_JoystickSetVirtualHat(*device, 0, SDL_HAT_LEFTUP);
  const auto events = joystick.take();
  ASSERT_EQ(events.size(), 4u);
  const auto expect = [&](Part part, int number, double value) {
    const auto event = std::ranges::find_if(
        events, [&](const auto& e) { return e.part == part && e.number == number; });
    ASSERT_NE(event, events.end()) << "nothing of " << static_cast<int>(part);
    EXPECT_EQ(event->value, value);
  };
  expect(Part::axis, 1, -1);
  expect(Part::button, 6, 1);
  expect(Part::hatX, 0, -1);
  expect(Part::hatY, 0, -1);
  EXPECT_TRUE(joystick.take().empty());
  SDL_JoystickSetVirtualButton(*device, 6, 0);
  const auto released = joystick.take();
  ASSERT_EQ(released.size(), 1u);
  EXPECT_EQ(released[0].value, 0);
}

TEST(SdlJoystick, IsTakenAgainWhenItIsPluggedInAgain) {
  VirtualJoystick device;
  auto opened = SdlJoystick::open();
  ASSERT_TRUE(opened) << opened.error().text();
  device.pullOut();
  (*opened)->take();
  device.plugIn();
  (*opened)->take();
  SDL_JoystickSetVirtualButton(*device, 2, 1);
  const auto events = (*opened)->take();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].number, 2);
}

TEST(SdlJoystick, IsRefusedIfNoneIsPluggedIn) {
  const auto opened = SdlJoystick::open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().what, "none is plugged in");
}

}  // namespace
}  // namespace gt
