#include "base/Result.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Error, NamesFileLineAndField) {
  EXPECT_EQ((Error{.file = "a.cfg", .line = 3, .field = "gain", .what = "is no number"}.text()),
            "a.cfg:3: gain: is no number");
  EXPECT_EQ((Error{.file = "a.cfg", .what = "is missing", .severity = Severity::warning}.text()),
            "a.cfg: warning: is missing");
  EXPECT_EQ((Error{.what = "wrong"}.text()), "wrong");
}

TEST(Error, NamesTheColumnBehindTheLine) {
  EXPECT_EQ(
      (Error{.file = "a.scene", .line = 2, .column = 18, .field = "x", .what = "is wrong"}.text()),
      "a.scene:2:18: x: is wrong");
  EXPECT_EQ((Error{.file = "a", .column = 3, .what = "is wrong"}.text()), "a: is wrong")
      << "a column is one of a line";
}

}  // namespace
}  // namespace gt
