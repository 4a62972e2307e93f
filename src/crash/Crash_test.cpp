#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "crash/Symbolizer.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

using testing::HasSubstr;

std::string contentOf(const std::string& path) {
  std::ifstream file{path};
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The program that dies on purpose.
std::string crashChild() {
  return programFolder() + "/crash_child";
}

/// The line of the child's source that ends in a mark.
int lineOf(const std::string& mark) {
  std::ifstream file{"src/crash/crash_child.cpp"};
  int line = 1;
  for (std::string text; std::getline(file, text); ++line)
    if (text.ends_with("// " + mark)) return line;
  return 0;
}

class Crash : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path{testing::TempDir()} / ("crash_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs the child until it dies; returns its report.
  CrashReport crash(const std::string& program, const std::string& how, int signal) {
    const pid_t child = fork();
    if (child == 0) {
      const rlimit none{0, 0};
      setrlimit(RLIMIT_CORE, &none);
      execl(program.c_str(), program.c_str(), folder_.c_str(), how.c_str(), nullptr);
      _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    EXPECT_EQ(WTERMSIG(status), signal);
    const std::string path =
        (folder_ / ("crash-crash_child-" + std::to_string(child) + ".txt")).string();
    text_ = contentOf(path);
    const auto report = parseCrashReport(text_, path);
    EXPECT_TRUE(report) << report.error().text();
    if (!report) return {};
    EXPECT_TRUE(report->complete);
    EXPECT_EQ(report->program, "crash_child");
    EXPECT_EQ(report->process, child);
    EXPECT_EQ(report->signalNumber, signal);
    EXPECT_EQ(report->running, how.starts_with("thread") ? "" : "red1, Doubler");
    EXPECT_EQ(report->notes.size(), 32u);
    EXPECT_THAT(report->notes, testing::Contains("red1, Doubler: step 39"));
    return *report;
  }

  /// The place of a frame, the first one that names a function of the child.
  static SourcePlace placeOf(const CrashReport& report, const std::string& function,
                             const std::vector<std::string>& folders = {}) {
    Symbolizer symbolizer{report, folders};
    const auto stack = report.callStack();
    for (std::size_t i = 0; i < std::min<std::size_t>(stack.size(), 12); ++i)
      for (const SourcePlace& place : symbolizer.places(stack[i] - (i > 0 ? 1 : 0)))
        if (place.function.find(function) != std::string::npos) return place;
    return {};
  }

  const std::string& text() const { return text_; }

 private:
  std::filesystem::path folder_;
  std::string text_;
};

void expectPlace(const SourcePlace& place, const std::string& function, const std::string& mark) {
  EXPECT_THAT(place.function, HasSubstr(function));
  EXPECT_THAT(place.file, testing::EndsWith("src/crash/crash_child.cpp"));
  EXPECT_EQ(place.line, lineOf(mark));
}

TEST_F(Crash, TellsWhereAnAccessFailed) {
  const CrashReport report = crash(crashChild(), "segv", SIGSEGV);
  EXPECT_EQ(report.signal, "SIGSEGV");
  EXPECT_EQ(report.address, 0u);
  expectPlace(placeOf(report, "writeNowhere"), "crashes::writeNowhere(int volatile*)", "segv");
  EXPECT_THAT(placeOf(report, "die").function, HasSubstr("crashes::die"));
  EXPECT_EQ(placeOf(report, "main").function, "main");
  Symbolizer symbolizer{report, {}};
  EXPECT_EQ(symbolizer.places(report.programCounter()).front().function,
            "crashes::writeNowhere(int volatile*)");
  const auto assembler = symbolizer.assembler(report.programCounter(), 3);
  ASSERT_TRUE(assembler) << assembler.error().text();
  const auto at = std::find_if(assembler->begin(), assembler->end(), [&](const Instruction& i) {
    return i.address == report.programCounter();
  });
  ASSERT_NE(at, assembler->end());
  EXPECT_THAT(at->text, HasSubstr("mov"));
  EXPECT_EQ(at->place.line, lineOf("segv"));
}

TEST_F(Crash, TellsWhoSentTheSignal) {
  const CrashReport report = crash(crashChild(), "killed", SIGSEGV);
  EXPECT_EQ(report.sender, report.process);
  EXPECT_EQ(report.address, 0u);
  EXPECT_EQ(crash(crashChild(), "segv", SIGSEGV).sender, 0);
}

TEST_F(Crash, TellsWhoGaveUp) {
  expectPlace(placeOf(crash(crashChild(), "abort", SIGABRT), "giveUp"), "crashes::giveUp()",
              "abort");
}

TEST_F(Crash, TellsOfADivisionByZero) {
#if defined(__aarch64__)
  GTEST_SKIP() << "this processor divides by zero";
#endif
  expectPlace(placeOf(crash(crashChild(), "divide", SIGFPE), "divideBy"), "crashes::divideBy(int)",
              "divide");
}

TEST_F(Crash, TellsOfAStackOverflow) {
  for (const char* how : {"overflow", "thread-overflow"})
    EXPECT_THAT(placeOf(crash(crashChild(), how, SIGSEGV), "recurse").function,
                HasSubstr("crashes::recurse(int)"))
        << how;
}

TEST_F(Crash, TellsOfAThread) {
  const CrashReport report = crash(crashChild(), "thread", SIGSEGV);
  EXPECT_NE(report.thread, report.process);
  expectPlace(placeOf(report, "writeNowhere"), "crashes::writeNowhere(int volatile*)", "segv");
}

TEST_F(Crash, FindsTheSymbolsOfAStrippedProgramByItsBuildId) {
  const std::string apart = programFolder() + "/../crash_child_stripped";
  const CrashReport report = crash(apart + "/crash_child", "segv", SIGSEGV);
  EXPECT_EQ(placeOf(report, "writeNowhere").file, "");
  expectPlace(placeOf(report, "writeNowhere", {apart + "/symbols"}),
              "crashes::writeNowhere(int volatile*)", "segv");
  Symbolizer symbolizer{report, {apart + "/symbols"}};
  const auto assembler = symbolizer.assembler(report.programCounter(), 3);
  ASSERT_TRUE(assembler) << assembler.error().text();
  ASSERT_FALSE(assembler->empty());
  EXPECT_EQ(assembler->front().place.function, "crashes::writeNowhere(int volatile*)");
}

TEST_F(Crash, DoesNotTakeAnotherProgramForTheOneThatCrashed) {
  CrashReport report = crash(crashChild(), "segv", SIGSEGV);
  for (CrashModule& module : report.modules) module.buildId = "00ff00ff";
  Symbolizer symbolizer{report, {}};
  EXPECT_EQ(symbolizer.places(report.programCounter()).front().function, "?");
  ASSERT_FALSE(symbolizer.missing().empty());
  EXPECT_THAT(symbolizer.missing().front().text(), HasSubstr("its build id differs"));
}

TEST_F(Crash, ReadsReportsAsOtherMachinesWriteThem) {
  const CrashReport whole = crash(crashChild(), "segv", SIGSEGV);
  std::string other = "\xEF\xBB\xBF";
  for (const char c : text()) other += c == '\n' ? "\r\n" : std::string(1, c);
  const auto report = parseCrashReport(other, "mailed.txt");
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_TRUE(report->complete);
  EXPECT_EQ(report->signal, whole.signal);
  EXPECT_EQ(report->frames, whole.frames);
}

TEST_F(Crash, ReadsReportsThatAreCutOffOrBroken) {
  const CrashReport whole = crash(crashChild(), "segv", SIGSEGV);
  ASSERT_GT(whole.frames.size(), 2u);
  // Without the last line break nothing is missing.
  for (std::size_t size = 0; size + 1 < text().size(); size += 13) {
    const auto report = parseCrashReport(text().substr(0, size), "cut.txt");
    EXPECT_TRUE(!report || !report->complete);
  }
  const auto beforeFrames = parseCrashReport(text().substr(0, text().find("frame ")), "cut.txt");
  ASSERT_TRUE(beforeFrames);
  EXPECT_TRUE(beforeFrames->frames.empty());
  expectPlace(placeOf(*beforeFrames, "writeNowhere"), "crashes::writeNowhere(int volatile*)",
              "segv");
  EXPECT_EQ(parseCrashReport("garbage\n", "a.txt").error().text(), "a.txt:1: is no crash report");
  EXPECT_EQ(parseCrashReport("gt2003 crash report 1\nsignal x\n", "a.txt").error().line, 2);
}

}  // namespace
}  // namespace gt
