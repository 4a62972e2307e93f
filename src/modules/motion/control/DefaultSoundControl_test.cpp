#include "modules/motion/control/DefaultSoundControl.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace gt {
namespace {

TEST(DefaultSoundControl, BeginsASoundWhenItIsRequested) {
  DefaultSoundControl control;
  Speaker speaker;
  const auto request = [&](Sound sound, int ms) {
    control.update({sound}, {Time{ms}}, speaker);
    return speaker.began;
  };
  EXPECT_EQ(request(Sound::none, 0), never());
  EXPECT_EQ(request(Sound::bing, 8), Time{8});
  EXPECT_EQ(speaker.sound, Sound::bing);
  EXPECT_EQ(request(Sound::bing, 16), Time{8}) << "once, however long it is requested";
  EXPECT_EQ(request(Sound::rise, 24), Time{24});
  EXPECT_EQ(request(Sound::none, 32), Time{24}) << "it is played to its end";
  EXPECT_EQ(speaker.sound, Sound::rise);
  EXPECT_EQ(request(Sound::rise, 40), Time{40});
}

TEST(Sounds, HaveAWaveFileEach) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator{"sounds"})
    files += entry.path().extension() == ".wav";
  EXPECT_EQ(files, enumCount<Sound> - 1);
  for (std::size_t i = 1; i < enumCount<Sound>; ++i)
    EXPECT_TRUE(std::filesystem::exists("sounds/" + std::string{enumNames<Sound>[i]} + ".wav"))
        << enumNames<Sound>[i];
}

}  // namespace
}  // namespace gt
