#include "commandline/CommandLine.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace gt {
namespace {

using testing::HasSubstr;

/// The arguments of a program, as main() gets them.
class Arguments {
 public:
  explicit Arguments(std::vector<std::string> words) : words_{std::move(words)} {
    words_.insert(words_.begin(), "/usr/bin/program");
    for (std::string& word : words_) pointers_.push_back(word.data());
  }
  int count() const { return static_cast<int>(pointers_.size()); }
  char** values() { return pointers_.data(); }

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

/// Runs a program that has an option and returns what an action returns.
template <typename F>
int run(std::vector<std::string> words, F action) {
  Arguments arguments{std::move(words)};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  int number = 0;
  line.app().add_option("--number", number);
  return line.run(action);
}

TEST(CommandLine, TheActionsStatusIsThePrograms) {
  EXPECT_EQ(run({}, [] { return 1; }), 1);
  EXPECT_EQ(run({}, [] { return Result<int>{1}; }), 1);
  EXPECT_EQ(run({}, [] { return Result<void>{}; }), 0);
}

TEST(CommandLine, AnErrorIsOneLineAndStatus2) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({},
                [] {
                  return Result<void>{
                      Error{.file = "file", .line = 3, .field = "field", .what = "is wrong"}};
                }),
            2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "program: file:3: field: is wrong\n");
}

TEST(CommandLine, WhatIsWrongInALineIsOneLineAndStatus2) {
  const auto refusal = [](std::vector<std::string> words) {
    Arguments arguments{std::move(words)};
    CommandLine line{arguments.count(), arguments.values(), "A program"};
    double number = 0;
    std::vector<double> numbers;
    std::uint64_t count = 0;
    bool flag = false;
    const auto addTo = [&](CLI::App& app) {
      app.add_option("--number", number)->check(CLI::Range(0., 1.));
      app.add_option("--numbers", numbers);
      app.add_option("--count", count);
      app.add_flag("--flag", flag);
    };
    addTo(line.app());
    addTo(line.command("do", "Does it", [] { return 0; }));
    testing::internal::CaptureStderr();
    EXPECT_EQ(line.run([] { return 0; }), 2);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
    EXPECT_TRUE(text.starts_with("program: ")) << text;
    return text;
  };
  EXPECT_THAT(refusal({"--flagg"}), HasSubstr("--flagg"));
  EXPECT_THAT(refusal({"--flag=maybe"}), HasSubstr("--flag = maybe"));
  EXPECT_THAT(refusal({"--number", "two"}), HasSubstr("--number: Value two"));
  for (const std::string text : {"nan", "inf"}) {
    EXPECT_THAT(refusal({"--number=" + text}), HasSubstr("--number: "));
    EXPECT_THAT(refusal({"do", "--number=" + text}), HasSubstr("--number: "));
    EXPECT_THAT(refusal({"do", "--numbers", "1", text}), HasSubstr(text + " is no number"));
  }
  EXPECT_THAT(refusal({"--count=-1"}), HasSubstr("--count: -1 is less than 0"));
  EXPECT_THAT(refusal({"do", "--count", "-1"}), HasSubstr("--count: -1 is less than 0"));
}

TEST(CommandLine, ExceptionsOfTheSystemAreOneLineAndStatus2) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({}, []() -> int { throw std::bad_alloc{}; }), 2);
  EXPECT_EQ(run({},
                []() -> int {
                  throw std::filesystem::filesystem_error{
                      "temp_directory_path", "/nowhere",
                      std::make_error_code(std::errc::no_such_file_or_directory)};
                }),
            2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "program: not enough memory\nprogram: /nowhere: No such file or directory\n");
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({},
                []() -> int {
                  throw std::filesystem::filesystem_error{
                      "temp_directory_path",
                      std::make_error_code(std::errc::no_such_file_or_directory)};
                }),
            2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("program: exception: filesystem error: temp_directory_path: No such file"));
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({}, []() -> int { throw std::runtime_error{"is wrong"}; }), 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "program: exception: is wrong\n");
}

/// Prints to somebody who reads nothing. Does not return.
void printToNobody(void (*onPipe)(int)) {
  std::signal(SIGPIPE, onPipe);
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0 || dup2(ends[1], STDOUT_FILENO) < 0) std::_Exit(1);
  close(ends[0]);
  std::_Exit(run({}, [] {
    std::fputs("a line\n", stdout);
    return 0;
  }));
}

TEST(CommandLineDeathTest, EndsQuietlyIfItsReaderHasGone) {
  EXPECT_EXIT(printToNobody(SIG_DFL), testing::KilledBySignal(SIGPIPE), "^$");
  EXPECT_EXIT(printToNobody(SIG_IGN), testing::ExitedWithCode(128 + SIGPIPE), "^$");
}

/// By default the system ends a program whose file may not grow, without a word.
TEST(CommandLine, AFileThatMayNotGrowIsAnErrorOfItsWriter) {
  const auto handler = std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(run({},
                [] {
                  std::FILE* file = std::tmpfile();
                  rlimit before{};
                  getrlimit(RLIMIT_FSIZE, &before);
                  const rlimit none{0, before.rlim_max};
                  setrlimit(RLIMIT_FSIZE, &none);
                  const bool failed = write(fileno(file), "x", 1) < 0 && errno == EFBIG;
                  setrlimit(RLIMIT_FSIZE, &before);
                  std::fclose(file);
                  return failed ? 0 : 1;
                }),
            0);
  std::signal(SIGXFSZ, handler);
}

TEST(CommandLine, AWrongOptionIsStatus2AndRunsNothing) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run({"--number", "many"},
                []() -> int {
                  ADD_FAILURE() << "ran";
                  return 0;
                }),
            2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--number"));
}

TEST(CommandLine, RunsTheCommandThatIsGivenWithOptionsOfTheProgramBehindIt) {
  Arguments arguments{{"second", "--number", "7"}};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  int number = 0;
  line.app().add_option("--number", number);
  line.command("first", "", [] { return 10; });
  line.command("second", "", [&] { return number; });
  EXPECT_EQ(line.run(), 7);
}

/// Runs a program with a command and an action for when it is not given.
int runWithDefault(std::vector<std::string> words) {
  Arguments arguments{std::move(words)};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  line.command("command", "", [] { return 10; });
  return line.run([] { return 20; });
}

TEST(CommandLine, WithoutACommandTheActionIsPerformed) {
  EXPECT_EQ(runWithDefault({}), 20);
  EXPECT_EQ(runWithDefault({"command"}), 10);
}

TEST(CommandLine, ACommandMustBeGivenIfThereIsNoAction) {
  Arguments arguments{{}};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  line.command("command", "", [] { return 10; });
  testing::internal::CaptureStderr();
  EXPECT_EQ(line.run(), 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("subcommand"));
}

TEST(CommandLine, TheRootIsKnownBeforeTheOptionsAreParsed) {
  Arguments arguments{{"--root", "."}};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  EXPECT_EQ(line.root().path("config"), "config");
  EXPECT_EQ(line.run([] { return 0; }), 0);
}

TEST(CommandLine, ARootThatIsNoneIsAnErrorOfTheRun) {
  Arguments arguments{{"--root=/nowhere"}};
  CommandLine line{arguments.count(), arguments.values(), "A program"};
  (void)line.root();
  testing::internal::CaptureStderr();
  EXPECT_EQ(line.run([] { return 0; }), 2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "program: /nowhere: --root: is no data root: it has no folder 'behavior'\n");
}

}  // namespace
}  // namespace gt
