#include "network/Keys.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>

#include "base/File.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::TestFolder;

TEST(Keys, ArePairsInFilesForTheUserAlone) {
  // Often enough that all characters of the keys' text have come up.
  for (int i = 0; i < 20; ++i) {
    const TestFolder folder;
    ASSERT_TRUE(makeKeys(folder.file("keys")));
    const auto robot = loadKeys(folder.file("keys/robot.key"));
    const auto tool = loadKeys(folder.file("keys/tool.key"));
    ASSERT_TRUE(robot && tool) << robot.error().text();
    EXPECT_TRUE(robot->canListen());
    EXPECT_FALSE(robot->canConnect());
    EXPECT_TRUE(tool->canConnect());
    EXPECT_FALSE(tool->canListen());
    EXPECT_EQ(robot->serverPublic, tool->serverPublic);
    struct stat status {};
    ASSERT_EQ(stat(folder.file("keys/robot.key").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u);
    EXPECT_FALSE(makeKeys(folder.file("keys"))) << "would replace keys that are in use";
  }
}

TEST(Keys, LieInAFolderForTheUserAlone) {
  const TestFolder folder;
  const mode_t before = umask(0);
  ASSERT_TRUE(makeKeys(folder.file("made")));
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(folder.file("made").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700u);
}

/// As on a disk that is full.
TEST(Keys, ThatCannotBeWrittenLeaveNothingBehind) {
  const TestFolder folder;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  for (const rlim_t room : {0, 50}) {
    const rlimit few{room, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &few), 0);
    const auto done = makeKeys(folder.file("keys"));
    setrlimit(RLIMIT_FSIZE, &before);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().what.substr(0, 19), "cannot be written: ");
    EXPECT_TRUE(std::filesystem::is_empty(folder.file("keys")));
  }
  std::signal(SIGXFSZ, handler);
  std::filesystem::create_directory(folder.file("keys/tool.key"));
  EXPECT_FALSE(makeKeys(folder.file("keys")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("keys/robot.key")))
      << "nor one without the other";
  std::filesystem::remove(folder.file("keys/tool.key"));
  EXPECT_TRUE(makeKeys(folder.file("keys")));
}

TEST(Keys, WrongFilesAreTold) {
  const TestFolder folder;
  EXPECT_FALSE(loadKeys(folder.file("none.key")));
  ASSERT_TRUE(writeFile(folder.file("short.key"), "serverPublic abc\n"));
  const auto keys = loadKeys(folder.file("short.key"));
  ASSERT_FALSE(keys);
  EXPECT_EQ(keys.error().field, "serverPublic");
}

}  // namespace
}  // namespace gt
