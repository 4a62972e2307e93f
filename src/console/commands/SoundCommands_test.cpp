#include <cstdlib>

#include "base/File.h"
#include "console/TestSession.h"
#include "representations/behavior/SoundRequest.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using SoundCommands = SessionTest;

/// SDL's loudspeaker is a file.
TEST_F(SoundCommands, PlaysWhatRobotsPlay) {
  setenv("SDL_AUDIODRIVER", "disk", 1);
  setenv("SDL_DISKAUDIOFILE", file("heard").c_str(), 1);
  EXPECT_THAT(answers("sound ?"), Contains("bing"));
  expectFine("sr BehaviorControl disabled");
  expectFine("robot red1");
  expectFine("sound on");
  expectFine("run 100 ms");
  EXPECT_FALSE(std::filesystem::exists(file("heard")));
  expectFine("sound bing");
  screen.printed.clear();
  expectFine("run 100 ms");
  EXPECT_THAT(screen.printed, IsEmpty());
  EXPECT_EQ(robot(0).provided<Speaker>()->sound, Sound::bing);
  EXPECT_EQ(session->simulation().output(0).speaker.sound, Sound::bing);
  EXPECT_TRUE(std::filesystem::exists(file("heard")));
  expectFine("sound off");
  expectError("sound moo", "moo", "no such sound");
}

TEST_F(SoundCommands, ReportsOnceThatThisMachineCannotPlay) {
  setenv("SDL_AUDIODRIVER", "nothing", 1);
  expectFine("sr BehaviorControl disabled");
  expectFine("sound on");
  expectFine("run 100 ms");
  expectFine("sound rise");
  screen.printed.clear();
  expectFine("run 100 ms");
  EXPECT_THAT(screen.printed, testing::ElementsAre(HasSubstr("there is no audio")));
  expectFine("sound fall");
  screen.printed.clear();
  expectFine("run 100 ms");
  EXPECT_THAT(screen.printed, IsEmpty());
}

}  // namespace
}  // namespace gt
