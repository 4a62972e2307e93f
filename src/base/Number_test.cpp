#include "base/Number.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace gt {
namespace {

TEST(Number, IsTheWholeText) {
  EXPECT_EQ(numberFrom<int>("-12"), -12);
  EXPECT_EQ(numberFrom<double>("1.5e3"), 1500);
  EXPECT_EQ(numberFrom<std::uint64_t>("ff", 16), 255u);
  for (const char* wrong : {"", " 1", "1 ", "1,", "+1", "0x1", "one"}) {
    EXPECT_FALSE(numberFrom<int>(wrong)) << wrong;
    EXPECT_FALSE(numberFrom<double>(wrong)) << wrong;
  }
  EXPECT_FALSE(numberFrom<int>("1.5"));
  EXPECT_FALSE(numberFrom<std::uint8_t>("256"));
  EXPECT_FALSE(numberFrom<unsigned>("-1"));
  EXPECT_FALSE(numberFrom<double>("1e999"));
}

TEST(Number, IsWrittenAsShortAsItCanBe) {
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(0.1f), "0.1");
  EXPECT_EQ(numberText(std::int8_t{-128}), "-128");
  const double number = 1.0 / 3;
  EXPECT_EQ(numberFrom<double>(numberText(number)), number);
}

}  // namespace
}  // namespace gt
