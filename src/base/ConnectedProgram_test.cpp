#include "base/ConnectedProgram.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <csignal>

namespace gt {
namespace {

TEST(ConnectedProgram, TalksOverItsStandardInput) {
  auto program = ConnectedProgram::start({"/bin/sh", "-c", "read line; echo \"$line\" >&0"});
  ASSERT_TRUE(program) << program.error().text();
  const FileDescriptor socket = program->takeSocket();
  ASSERT_EQ(send(socket.number(), "hello\n", 6, 0), 6);
  std::array<char, 16> answer{};
  EXPECT_EQ(recv(socket.number(), answer.data(), answer.size(), 0), 6);
  EXPECT_STREQ(answer.data(), "hello\n");
  EXPECT_EQ(program->ending(), "has ended with status 0");
}

TEST(ConnectedProgram, SaysHowItEnded) {
  auto failing = ConnectedProgram::start({"/bin/sh", "-c", "exit 3"});
  ASSERT_TRUE(failing);
  EXPECT_EQ(failing->ending(), "has ended with status 3");
  auto killed = ConnectedProgram::start({"/bin/sh", "-c", "kill -11 $$"});
  ASSERT_TRUE(killed);
  EXPECT_EQ(killed->ending(), "was ended by signal 11");
  const auto none = ConnectedProgram::start({"/nowhere/program"});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(), "/nowhere/program: cannot be started: No such file or directory");
}

TEST(ConnectedProgram, EndsWithItsOwner) {
  pid_t id = 0;
  {
    auto program = ConnectedProgram::start({"/bin/cat"});
    ASSERT_TRUE(program);
    id = program->id();
    EXPECT_EQ(kill(id, 0), 0);
  }
  EXPECT_NE(kill(id, 0), 0) << "cat ends with its input";
  {
    auto program = ConnectedProgram::start({"/bin/sleep", "1000"});
    ASSERT_TRUE(program);
    id = program->id();
  }
  EXPECT_NE(kill(id, 0), 0) << "it does not look at its input";
}

}  // namespace
}  // namespace gt
