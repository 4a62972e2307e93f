#include "base/EndSignals.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <thread>

namespace gt {
namespace {

bool isReadable(int file) {
  pollfd waiting{file, POLLIN, 0};
  return poll(&waiting, 1, 0) > 0;
}

/// Signals do what they do by default, whatever the tests were started with.
class EndSignalsTest : public testing::Test {
 protected:
  EndSignalsTest() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  }
};
using EndSignalsDeathTest = EndSignalsTest;

TEST_F(EndSignalsTest, KeepsTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    int woken = 0;
    EndSignals signals{[&] { ++woken; }};
    EXPECT_EQ(signals.received(), 0);
    EXPECT_FALSE(isReadable(signals.event()));
    raise(signal);
    EXPECT_EQ(signals.received(), signal);
    EXPECT_EQ(signals.status(), 128 + signal);
    EXPECT_TRUE(isReadable(signals.event()));
    EXPECT_EQ(woken, 1);
  }
}

TEST_F(EndSignalsTest, SignalsThatComeTogetherAreOne) {
  EndSignals signals{{}, 1'000'000};
  raise(SIGTERM);
  raise(SIGTERM);
  raise(SIGHUP);
  EXPECT_EQ(signals.received(), SIGTERM);
}

TEST_F(EndSignalsDeathTest, ASecondSignalEndsAtOnce) {
  const auto raiseBoth = [](int first, int second) {
    EndSignals signals{{}, 0};
    raise(first);
    raise(second);
  };
  EXPECT_EXIT(raiseBoth(SIGINT, SIGINT), testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(raiseBoth(SIGINT, SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST_F(EndSignalsTest, AfterOneIsForgottenTheNextIsTheFirst) {
  EndSignals signals;
  raise(SIGINT);
  signals.forget();
  EXPECT_EQ(signals.received(), 0);
  EXPECT_FALSE(isReadable(signals.event()));
  raise(SIGTERM);
  EXPECT_EQ(signals.received(), SIGTERM);
}

TEST_F(EndSignalsTest, WhatIsIgnoredStaysIgnored) {
  std::signal(SIGHUP, SIG_IGN);
  {
    EndSignals signals;
    raise(SIGHUP);
    EXPECT_EQ(signals.received(), 0);
  }
  std::signal(SIGHUP, SIG_DFL);
}

TEST_F(EndSignalsTest, EndsAWaitForInput) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  EndSignals signals;
  ASSERT_EQ(write(ends[1], "x", 1), 1);
  EXPECT_TRUE(signals.waitFor(ends[0]));
  char taken = 0;
  ASSERT_EQ(read(ends[0], &taken, 1), 1);
  // The handler runs in whatever thread the signal finds.
  std::thread other{[] { raise(SIGTERM); }};
  EXPECT_FALSE(signals.waitFor(ends[0]));
  other.join();
  EXPECT_FALSE(signals.waitFor(ends[0]));
  close(ends[0]);
  close(ends[1]);
}

TEST_F(EndSignalsTest, AClosedTerminalTakesWhatIsPrinted) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    const EndSignals signals;
    static_cast<void>(write(STDOUT_FILENO, "ready", 5));
    signals.waitFor(signals.event());
    _exit(write(STDOUT_FILENO, "gone", 4) == 4 ? signals.status() : 1);
  }
  char text[5];
  ASSERT_EQ(read(terminal, text, 5), 5);
  close(terminal);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGHUP);
}

TEST_F(EndSignalsTest, WhatIsPrintedForNobodyEndsTheProgramInOrder) {
  std::array<int, 2> output{};
  ASSERT_EQ(pipe(output.data()), 0);
  close(output[0]);  // before anybody writes
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGPIPE, SIG_DFL);
    dup2(output[1], STDOUT_FILENO);
    close(output[1]);
    const EndSignals signals{{}, 0};
    const bool first = write(STDOUT_FILENO, "lost", 4) == 4;
    const bool second = write(STDOUT_FILENO, "gone", 4) == 4;
    _exit(!first && second ? signals.status() : 1);
  }
  close(output[1]);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGPIPE);
}

/// Of a program that this one has started, for instance.
TEST_F(EndSignalsTest, AnotherPipeThatNobodyReadsIsAnErrorOfItsWriter) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  const EndSignals signals;
  EXPECT_EQ(write(ends[1], "x", 1), -1);
  EXPECT_EQ(errno, EPIPE);
  EXPECT_EQ(signals.received(), 0);
  close(ends[1]);
}

}  // namespace
}  // namespace gt
