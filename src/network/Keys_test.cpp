#include "network/Keys.h"

#include <sys/stat.h>

#include "streams/File.h"
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
