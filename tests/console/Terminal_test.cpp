#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/TemporaryFolder.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

using ::testing::HasSubstr;

const std::string simgt = programFolder() + "/simgt";
constexpr const char* scene = "scenes/one-robot.scene";
constexpr const char *upKey = "\033[A", *clearKey = "\025", *interruptKey = "\003",
                     *prompt = "simgt> ";
/// How long the program may take for anything; under a sanitizer it takes long.
constexpr std::chrono::minutes patience{2};

/// Where the console keeps what was typed.
const TemporaryFolder stateFolder;

/// The program with its console in a terminal of 24 lines.
class Terminal {
 public:
  Terminal() {
    const winsize size{24, 100, 0, 0};
    pid_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ != 0) return;
    setenv("TERM", "xterm", 1);
    unsetenv("INPUTRC");
    setenv("XDG_STATE_HOME", stateFolder.path().c_str(), 1);
    execl(simgt.c_str(), simgt.c_str(), "console", scene, nullptr);
    _exit(127);
  }
  ~Terminal() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    close(terminal_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(const std::string& keys) {
    ASSERT_EQ(write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  /// What the program writes up to a text, which it removes; all there was if that does not come.
  std::string until(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + patience;
    std::size_t found;
    while ((found = written_.find(text)) == written_.npos &&
           std::chrono::steady_clock::now() < end && read()) {
    }
    EXPECT_NE(found, written_.npos) << "expected " << text << " in:\n" << written_;
    const std::size_t length = found == written_.npos ? written_.size() : found + text.size();
    std::string result = written_.substr(0, length);
    written_.erase(0, length);
    return result;
  }
  /// Ends the program by a command, and returns its exit status; -1 if it goes on.
  int exit() {
    type(std::string{clearKey} + "exit\n");
    const auto end = std::chrono::steady_clock::now() + patience;
    while (read())
      if (std::chrono::steady_clock::now() > end) return -1;
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  /// Whether the program still has its terminal.
  bool read() {
    pollfd waiting{terminal_, POLLIN, 0};
    if (poll(&waiting, 1, 1000) == 0) return true;
    std::array<char, 4096> bytes;
    const auto count = ::read(terminal_, bytes.data(), bytes.size());
    if (count > 0) written_.append(bytes.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string written_;
};

TEST(Terminal, CompletesCommandsKeysSolutionsAndOptions) {
  Terminal terminal;
  terminal.until(prompt);
  terminal.type("ec\tin one word\n");
  terminal.until("echo in one word\r\n");
  EXPECT_THAT(terminal.until(prompt), HasSubstr("\rin one word"));
  for (const auto& [typed, completed] :
       {std::pair{"dk send_selfLocatorF\t", "send_selfLocatorField_drawing "},
        {"sr BallLocator PID\t", "PIDSmoothed "},
        {"xo search_b\t", "search_ball "},
        {"get ball.spe\t", "ball.speed "},
        {"set emitters.am\t", "emitters.ambient "},
        {"layout sin\t", "layout single "},
        {"jbc 1 xo search_b\t", "search_ball "},
        {"call remo\t", "remote-control "}}) {
    terminal.type(typed);
    terminal.until(completed);
    terminal.type(clearKey);
  }
  EXPECT_EQ(terminal.exit(), 0);
}

TEST(Terminal, RemembersWhatWasTyped) {
  {
    Terminal terminal;
    terminal.until(prompt);
    terminal.type("echo first\n");
    terminal.until(prompt);
    terminal.type("echo second\n");
    terminal.until(prompt);
    terminal.type(std::string{upKey} + upKey);
    terminal.until("echo second");
    terminal.until("first");
    terminal.type("\n");
    EXPECT_THAT(terminal.until(prompt), HasSubstr("\rfirst"));
    EXPECT_EQ(terminal.exit(), 0);
  }
  EXPECT_TRUE(std::filesystem::exists(stateFolder.path() / "gt2003/console_history"));
  Terminal terminal;  // the next time, too: exit was the last, before it echo first
  terminal.until(prompt);
  terminal.type(std::string{upKey} + upKey);
  terminal.until("cho first");  // only what differs from exit is written anew
  EXPECT_EQ(terminal.exit(), 0);
}

TEST(Terminal, OffersWhatScriptsEcho) {
  Terminal terminal;
  terminal.until(prompt);
  terminal.type("call tests/console/echo.con\n");
  terminal.until("get time");
  terminal.until(prompt);
  terminal.type(std::string{upKey} + "\n");
  EXPECT_THAT(terminal.until(prompt), HasSubstr("\r0"));
  EXPECT_EQ(terminal.exit(), 0);
}

TEST(Terminal, ShowsTimeScoreAndFactorInALiveLine) {
  Terminal terminal;
  terminal.until(prompt);
  terminal.type("run 60\n");
  const std::string live = terminal.until("times real time");
  EXPECT_THAT(live, HasSubstr("\r\033[K\033[7m"));
  EXPECT_THAT(live, HasSubstr("0:0"));
  terminal.until("\r\033[K");
  terminal.until(prompt);
  terminal.type("nonsense\n");
  EXPECT_THAT(terminal.until(prompt), HasSubstr("\033[31mnonsense: there is no such command"));
  EXPECT_EQ(terminal.exit(), 0) << "what was typed wrongly was reported then";
}

TEST(Terminal, TimePassesWhileLinesAreTyped) {
  Terminal terminal;
  terminal.until(prompt);
  terminal.type("start\n");
  terminal.until("simgt 0:0");
  terminal.type("set radio.loss 0.25\n");
  terminal.until("simgt 0:0");
  terminal.type("echo still here\n");
  EXPECT_THAT(terminal.until("\rstill here"), HasSubstr("echo still here"));
  terminal.type("stop\n");
  terminal.until(prompt);
  terminal.type("expect time > 0\necho it has passed\n");
  terminal.until("\rit has passed");
  terminal.until(prompt);
  terminal.type("get time\n");
  const std::string first = terminal.until(prompt);
  terminal.type("get time\n");
  EXPECT_EQ(terminal.until(prompt), first);
  terminal.type("robot red3\n");
  terminal.until("simgt red3> ");
  EXPECT_EQ(terminal.exit(), 0);
}

TEST(Terminal, InterruptsKeepEverything) {
  Terminal terminal;
  terminal.until(prompt);
  terminal.type("set radio.loss 0.25\n");
  terminal.until(prompt);
  terminal.type("run 1000000\n");
  terminal.until("times real time");
  terminal.type(interruptKey);
  terminal.until("run: stopped at 0:");
  terminal.until(prompt);
  terminal.type("expect time > 0 and time < 1000000\nget radio.loss\n");
  terminal.until("\r0.25\r\n");
  terminal.type("start\n");
  terminal.until("simgt 0:");
  terminal.type(interruptKey);
  terminal.until("stopped at 0:");
  terminal.until(prompt);
  terminal.type("nonsense that is not meant");
  terminal.type(interruptKey);  // a line that is typed is thrown away
  terminal.until(prompt);
  EXPECT_EQ(terminal.exit(), 0);
}

/// What the program prints if lines are piped in, and its exit status.
std::pair<std::string, int> piped(const std::string& lines) {
  const std::string command = "printf '" + lines + "' | " + simgt + " console " + scene + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 512> bytes;
  while (const auto count = fread(bytes.data(), 1, bytes.size(), pipe))
    text.append(bytes.data(), count);
  return {text, WEXITSTATUS(pclose(pipe))};
}

TEST(Terminal, APipeIsPlain) {
  const auto [text, status] = piped("echo one\\nrun 1\\nexpect time == 1\\n");
  EXPECT_EQ(text, "one\n");
  EXPECT_EQ(status, 0);
  const auto [failed, failure] = piped("echo one\\nexpect time == 1\\necho never\\n");
  EXPECT_EQ(failed, "one\nsimgt: input:2: expect: does not hold: time == 1\n");
  EXPECT_EQ(failure, 1);
  EXPECT_EQ(piped("nonsense\\n").second, 2);
  EXPECT_EQ(piped("run 80ms\\nexit\\nnonsense\\n"), (std::pair{std::string{}, 0}));
}

TEST(Terminal, ACommandOfTheCommandLineThatFailsIsNamed) {
  const std::string command = simgt + " console " + scene + " -c 'echo one' -c 'run 3x' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 512> bytes{};
  std::string text;
  while (fgets(bytes.data(), bytes.size(), pipe)) text += bytes.data();
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2);
  EXPECT_THAT(text, HasSubstr("one\nsimgt: -c \"run 3x\": x: is no unit of time"));
}

}  // namespace
}  // namespace gt
