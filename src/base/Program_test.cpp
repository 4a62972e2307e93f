#include "base/Program.h"

#include <gtest/gtest.h>

#include <csignal>

namespace gt {
namespace {

TEST(Program, TakesInputAndLeavesOutput) {
  const std::string large(1 << 20, 'x');
  const auto cat = runProgram({"cat"}, large);
  ASSERT_TRUE(cat);
  EXPECT_EQ(cat->status, 0);
  EXPECT_EQ(cat->output, large);
  EXPECT_TRUE(cat->errors.empty());
}

TEST(Program, ReportsHowItEnded) {
  const auto shell = runProgram({"sh", "-c", "echo out; echo wrong >&2; exit 3"});
  ASSERT_TRUE(shell);
  EXPECT_EQ(shell->status, 3);
  EXPECT_EQ(shell->output, "out\n");
  EXPECT_EQ(shell->errors, "wrong\n");
  EXPECT_EQ(runProgram({"sh", "-c", "kill -9 $$"})->status, -SIGKILL);
  const auto missing = runProgram({"no-such-program"});
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().text().find("no-such-program: cannot be run"), std::string::npos);
}

}  // namespace
}  // namespace gt
