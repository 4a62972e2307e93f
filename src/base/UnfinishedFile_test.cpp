#include "base/UnfinishedFile.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/TemporaryFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

TEST(UnfinishedFile, IsWholeOrWasNeverThere) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "file").string();
  ASSERT_TRUE(writeFile(path, "what was there"));
  {
    const UnfinishedFile left{path};
    EXPECT_EQ(left.written(), path + ".part");
    ASSERT_TRUE(writeFile(left.written(), "half"));
  }
  EXPECT_EQ(*readFile(path), "what was there");
  EXPECT_FALSE(fs::exists(path + ".part"));
  {
    UnfinishedFile whole{path};
    ASSERT_TRUE(writeFile(whole.written(), "new"));
    ASSERT_TRUE(whole.finish());
  }
  EXPECT_EQ(*readFile(path), "new");
  EXPECT_FALSE(UnfinishedFile{path + "2"}.finish()) << "nothing was written";
}

TEST(UnfinishedFile, IsRemovedIfItCannotGetItsName) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "later").string();
  {
    UnfinishedFile file{path};
    ASSERT_TRUE(writeFile(file.written(), "whole"));
    fs::create_directory(path);
    EXPECT_FALSE(file.finish());
  }
  EXPECT_FALSE(fs::exists(path + ".part"));
}

}  // namespace
}  // namespace gt
