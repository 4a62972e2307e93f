#include "devices/SdlSpeaker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "base/TemporaryFolder.h"

namespace gt {
namespace {

std::string contentsOf(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// SDL's loudspeaker is a file.
TEST(SdlSpeaker, PlaysAWaveFile) {
  const TemporaryFolder folder;
  const std::string heard = (folder.path() / "heard").string();
  setenv("SDL_AUDIODRIVER", "disk", 1);
  setenv("SDL_DISKAUDIOFILE", heard.c_str(), 1);
  {
    SdlSpeaker speaker;
    EXPECT_FALSE(speaker.plays());
    const auto done = speaker.play("sounds/bing.wav");
    ASSERT_TRUE(done) << done.error().text();
    for (int i = 0; i < 6000 && speaker.plays(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    EXPECT_FALSE(speaker.plays());
  }
  const std::string samples = contentsOf("sounds/bing.wav").substr(44);  // behind the header
  EXPECT_NE(contentsOf(heard).find(samples), std::string::npos);
}

TEST(SdlSpeaker, RefusesWhatIsNoWaveFile) {
  SdlSpeaker speaker;
  EXPECT_EQ(speaker.play("no/such.wav").error().file, "no/such.wav");
  EXPECT_FALSE(speaker.play("CMakeLists.txt"));
  EXPECT_FALSE(speaker.plays());
}

}  // namespace
}  // namespace gt
