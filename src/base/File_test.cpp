#include "base/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/TemporaryFolder.h"
#include "support/FileSizeLimit.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  std::string path(const char* name) const { return (folder.path() / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator{folder.path()}, fs::directory_iterator{}));
  }

  TemporaryFolder folder;
};

TEST_F(FileTest, IsWrittenWholeOrNotAtAll) {
  ASSERT_TRUE(writeFile(path("file"), "what was there"));
  {
    auto left = OutputFile::open(path("file"));
    ASSERT_TRUE(left);
    EXPECT_TRUE(left->put("half"));
    EXPECT_EQ(*readFile(path("file")), "what was there");
  }
  {
    const FileSizeLimit limit{1000};
    const auto full = writeFile(path("file"), std::string(5000, 'x'));
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().text(), path("file") + ": cannot be written: File too large");
  }
  EXPECT_EQ(*readFile(path("file")), "what was there");
  EXPECT_EQ(files(), 1u);
  ASSERT_TRUE(writeFile(path("file"), "new"));
  EXPECT_EQ(*readFile(path("file")), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(FileTest, ALinkStaysOne) {
  ASSERT_TRUE(writeFile(path("file"), "what was there"));
  fs::create_symlink(path("file"), path("link"));
  ASSERT_TRUE(writeFile(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(*readFile(path("file")), "new");
}

TEST_F(FileTest, KeepsWhoMayReadIt) {
  ASSERT_TRUE(writeFile(path("file"), "what was there"));
  constexpr auto mine = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(path("file"), mine);
  ASSERT_TRUE(writeFile(path("file"), "new"));
  EXPECT_EQ(fs::status(path("file")).permissions(), mine);
}

TEST_F(FileTest, ADeviceIsWrittenUnderItsName) {
  EXPECT_TRUE(writeFile("/dev/null", "nothing"));
  EXPECT_FALSE(fs::exists("/dev/null.part"));
  EXPECT_FALSE(writeFile(folder.path().string(), "a folder"));
}

}  // namespace
}  // namespace gt
