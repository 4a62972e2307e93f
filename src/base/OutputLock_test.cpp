#include "base/OutputLock.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <filesystem>
#include <optional>

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputLockTest : public testing::Test {
 protected:
  OutputLockTest() { fs::remove_all(folder); }
  ~OutputLockTest() override { fs::remove_all(folder); }

  const std::string folder = (fs::path{testing::TempDir()} / "gt_output_lock").string();
};

TEST_F(OutputLockTest, AFolderIsForOne) {
  {
    const auto lock = OutputLock::ofFolder(folder + "/made");
    ASSERT_TRUE(lock) << lock.error().text();
    EXPECT_EQ(OutputLock::ofFolder(folder + "/made").error().text(),
              folder + "/made: is being written by another program or match");
    EXPECT_TRUE(OutputLock::ofFolder(folder));
  }
  EXPECT_TRUE(fs::is_empty(folder + "/made"));
  EXPECT_TRUE(OutputLock::ofFolder(folder + "/made"));
}

TEST_F(OutputLockTest, AMovedLockHoldsOn) {
  std::optional<OutputLock> kept;
  kept = std::move(*OutputLock::ofFolder(folder));
  EXPECT_FALSE(OutputLock::ofFolder(folder));
  kept.reset();
  EXPECT_TRUE(OutputLock::ofFolder(folder));
}

TEST_F(OutputLockTest, AProgramThatIsKilledLeavesNoLock) {
  const pid_t child = fork();
  if (child == 0) {
    const auto lock = OutputLock::ofFolder(folder);
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(fs::exists(folder + "/.lock"));
  EXPECT_TRUE(OutputLock::ofFolder(folder));
}

TEST_F(OutputLockTest, AFileIsForOneAndStays) {
  fs::create_directories(folder);
  const std::string file = folder + "/file";
  {
    const auto lock = OutputLock::ofFile(file);
    ASSERT_TRUE(lock);
    EXPECT_EQ(OutputLock::ofFile(file).error().file, file);
  }
  EXPECT_TRUE(fs::exists(file));
  EXPECT_TRUE(OutputLock::ofFile(file));
}

TEST_F(OutputLockTest, WhatCannotBeMadeIsAnError) {
  EXPECT_EQ(OutputLock::ofFolder("/dev/null/x").error().file, "/dev/null/x");
  EXPECT_THAT(OutputLock::ofFile(folder + "/no/file").error().text(),
              HasSubstr("cannot be written: No such file"));
}

}  // namespace
}  // namespace gt
