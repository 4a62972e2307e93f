#include "xabsl/tools/server/Uri.h"

#include <gtest/gtest.h>

namespace xabsl::server {
namespace {

TEST(Uri, NamesFilesBothWays) {
  EXPECT_EQ(fileUri("/a b/ü.xabsl"), "file:///a%20b/%C3%BC.xabsl");
  EXPECT_EQ(pathOf("file:///a%20b/%c3%BC.xabsl"), "/a b/ü.xabsl");
  EXPECT_EQ(pathOf("file:///a/./b/../c%2"), "/a/c%2");
  EXPECT_EQ(pathOf("untitled:1"), "untitled:1");
}

TEST(Uri, HasOnePathForAllItsSpellings) {
  for (const char* uri : {"file:/a/b.xabsl", "file://localhost/a/b.xabsl", "FILE:///a/b.xabsl",
                          "File://LOCALHOST/a/b.xabsl", "file:///a/%2E%2e/a//b.xabsl"})
    EXPECT_EQ(pathOf(uri), "/a/b.xabsl") << uri;
  EXPECT_EQ(pathOf("untitled:///a.xabsl"), pathOf(pathOf("untitled:///a.xabsl")));
}

}  // namespace
}  // namespace xabsl::server
