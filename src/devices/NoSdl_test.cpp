#include <gtest/gtest.h>

#include "devices/SdlJoystick.h"
#include "devices/SdlSpeaker.h"

namespace gt {
namespace {

TEST(NoSdl, SaysWhatIsMissing) {
  const auto joystick = SdlJoystick::open();
  ASSERT_FALSE(joystick);
  EXPECT_NE(joystick.error().text().find("libsdl2-dev"), std::string::npos);

  SdlSpeaker speaker;
  const auto played = speaker.play("sounds/bing.wav");
  ASSERT_FALSE(played);
  EXPECT_NE(played.error().text().find("sounds/bing.wav"), std::string::npos);
  EXPECT_FALSE(speaker.plays());
}

}  // namespace
}  // namespace gt
