#include "xabsl/tools/documentation/Html.h"

#include <gtest/gtest.h>

namespace xabsl {
namespace {

TEST(Html, TurnsWhatIsNoUtf8IntoLetters) {
  EXPECT_EQ(documentation::utf8("f\xFCr \xC3\xBC\x01 \xED\xA0\x80"),
            "f\xC3\xBCr \xC3\xBC \xC3\xAD\xC2\xA0\xC2\x80");
  EXPECT_EQ(documentation::escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
  EXPECT_EQ(documentation::encoded("a.b-c/d~"), "a.b-c~2Fd~7E");
  EXPECT_EQ(documentation::plainDoc("* one\n   * two\n\n three "), "one\ntwo\n\nthree");
}

}  // namespace
}  // namespace xabsl
