#include "robot/FileNames.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(FileNames, StandForPathsWhereverAnErrorHoldsThem) {
  const auto named = [](Error error) {
    return withFileNames(std::move(error), "/tmp/t",
                         [](const std::string& path) { return "team/" + path.substr(7); })
        .text();
  };
  EXPECT_EQ(named({.file = "/tmp/t/a b.cfg", .line = 3, .what = "is wrong"}),
            "team/a b.cfg:3: is wrong");
  EXPECT_EQ(named({.file = "x",
                   .field = "/tmp/t/y",
                   .what = "needed (/tmp/t/o/a.xabsl:17), see "
                           "'/tmp/t/b' and /tmp/t/c"}),
            "x: team/y: needed (team/o/a.xabsl:17), see 'team/b' and team/c");
  EXPECT_EQ(named({.file = "/tmp/tea", .what = "not /tmp/tea or /tmp/t"}),
            "/tmp/tea: not /tmp/tea or /tmp/t");
}

}  // namespace
}  // namespace gt
