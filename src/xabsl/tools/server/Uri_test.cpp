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

}  // namespace
}  // namespace xabsl::server
