#include "base/Findings.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Findings, FailOnErrorsAndStrictlyOnWarnings) {
  Findings findings;
  findings.add(Result<void>{});
  EXPECT_TRUE(findings.empty());
  findings.warn({.file = "a.cfg", .line = 2, .field = "gain", .what = "is not used"});
  EXPECT_FALSE(findings.fail(false));
  EXPECT_TRUE(findings.fail(true));
  EXPECT_TRUE(findings.firstError());

  Findings more;
  more.add(Result<void>{Error{.file = "b.cfg", .what = "is missing"}});
  findings.add(std::move(more));
  EXPECT_TRUE(findings.fail(false));
  EXPECT_EQ(findings.errors(), 1u);
  EXPECT_EQ(findings.warnings(), 1u);
  EXPECT_EQ(findings.firstError().error().file, "b.cfg");
  EXPECT_EQ(findings.text(), "a.cfg:2: warning: gain: is not used\nb.cfg: is missing\n");
}

}  // namespace
}  // namespace gt
