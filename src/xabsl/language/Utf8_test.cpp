#include "xabsl/language/Utf8.h"

#include <gtest/gtest.h>

namespace xabsl {
namespace {

TEST(Utf8, MeasuresLetters) {
  EXPECT_EQ(letterLength("a\xC3\xBC"), 1u);
  EXPECT_EQ(letterLength("\xC3\xBC"), 2u);
  EXPECT_EQ(letterLength("\xF0\x9F\x98\x80"), 4u);
  for (const char* wrong :
       {"", "\xFC", "\xC3", "\xC3z", "\xC0\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80"})
    EXPECT_EQ(letterLength(wrong), 0u) << wrong;
}

TEST(Utf8, TakesOtherBytesForLatin1) {
  EXPECT_EQ(toUtf8("f\xC3\xBCr"), "f\xC3\xBCr");
  EXPECT_EQ(toUtf8("f\xFCr \xC3\xBC \xED\xA0\x80"), "f\xC3\xBCr \xC3\xBC \xC3\xAD\xC2\xA0\xC2\x80");
  EXPECT_EQ(toUtf8(""), "");
}

}  // namespace
}  // namespace xabsl
