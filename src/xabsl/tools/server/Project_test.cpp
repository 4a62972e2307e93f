#include "xabsl/tools/server/Project.h"

#include <gtest/gtest.h>

namespace xabsl::server {
namespace {

TEST(Lines, CountUnitsOfUtf16) {
  const Lines lines("a\n\xC3\xBC\xF0\x9F\x98\x80x");
  EXPECT_EQ(lines.position({0, 2, 3}).character, 3);
  EXPECT_EQ(lines.location({1, 3}, 0).column, 3);
  EXPECT_EQ(lines.offset({1, 3}), 8u);
}

}  // namespace
}  // namespace xabsl::server
