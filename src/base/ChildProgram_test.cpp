#include "base/ChildProgram.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

namespace gt {
namespace {

TEST(ChildProgram, RunsUntilItIsKilled) {
  ChildProgram child{{"/bin/sleep", "100"}};
  EXPECT_TRUE(child.runs());
  EXPECT_GE(child.memory(), 0);
  child.kill(SIGTERM);
  EXPECT_FALSE(child.runs());
  EXPECT_TRUE(WIFSIGNALED(child.status()));
  EXPECT_EQ(WTERMSIG(child.status()), SIGTERM);
  child.start();
  EXPECT_TRUE(child.runs());
}

TEST(ChildProgram, ReportsHowItEnded) {
  ChildProgram child{{"/bin/sh", "-c", "exit 3"}};
  for (int i = 0; i < 6000 && child.runs(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  ASSERT_FALSE(child.runs());
  EXPECT_EQ(WEXITSTATUS(child.status()), 3);
}

}  // namespace
}  // namespace gt
