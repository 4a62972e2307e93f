#include "base/Enum.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

enum class HeadMode { none, lookAtPoint, searchForBall };

TEST(Enum, KnowsItsNames) {
  static_assert(enumCount<HeadMode> == 3);
  EXPECT_EQ(enumName(HeadMode::searchForBall), "searchForBall");
  EXPECT_EQ(enumName(static_cast<HeadMode>(3)), "?");
}

TEST(Enum, ReadsTheReportsSpelling) {
  EXPECT_EQ(enumValue<HeadMode>("search-for-ball"), HeadMode::searchForBall);
  EXPECT_EQ(enumValue<HeadMode>("lookAtPoint"), HeadMode::lookAtPoint);
  EXPECT_EQ(enumValue<HeadMode>("look-at-"), std::nullopt);
  EXPECT_EQ(enumValue<HeadMode>(""), std::nullopt);
}

}  // namespace
}  // namespace gt
