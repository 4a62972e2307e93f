#include "base/Result.h"

#include <gtest/gtest.h>

#include "base/Column.h"

namespace gt {
namespace {

TEST(Error, NamesFileLineAndField) {
  EXPECT_EQ((Error{.file = "a.cfg", .line = 3, .field = "gain", .what = "is no number"}.text()),
            "a.cfg:3: gain: is no number");
  EXPECT_EQ((Error{.file = "a.cfg", .what = "is missing", .severity = Severity::warning}.text()),
            "a.cfg: warning: is missing");
  EXPECT_EQ((Error{.what = "wrong"}.text()), "wrong");
}

/// As compilers name places, whoever reports the error.
TEST(Error, NamesTheColumnBehindTheLine) {
  EXPECT_EQ((Error{.file = "a.scene", .line = 2, .field = "x", .what = withColumn("is wrong", 18)}
                 .text()),
            "a.scene:2:18: x: is wrong");
  EXPECT_EQ(withColumn("is wrong", 0), "is wrong");
  for (const std::string what : {"is wrong (column )", "is wrong (column x)", "(column 3) is wrong",
                                 "is wrong (column 3) here", "is wrong (column 3"})
    EXPECT_EQ((Error{.file = "a", .line = 2, .what = what}.text()), "a:2: " + what);
  EXPECT_EQ((Error{.file = "a", .what = "is wrong (column 3)"}.text()), "a: is wrong (column 3)")
      << "without a line";
}

}  // namespace
}  // namespace gt
