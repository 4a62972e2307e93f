#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/File.h"
#include "base/Random.h"
#include "base/TemporaryFolder.h"
#include "debug/Drawing.h"
#include "match/MatchSummary.h"
#include "streams/Json.h"
#include "streams/mcap/Mcap.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Where a program runs: in a pipe, in one that nobody reads, or in a terminal.
enum class Place { pipe, unreadPipe, terminal };
/// Where errors of a program in a pipe go: with what it prints, or to the file `errors`.
enum class Errors { printed, file };

/// A program of the build tree that runs in a folder, and what it prints.
class RunningProgram {
 public:
  RunningProgram(const fs::path& folder, std::vector<std::string> command,
                 Place place = Place::pipe, Errors errors = Errors::printed) {
    command.front() = programFolder() + "/" + command.front();
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> output{}, input{};
    if (place != Place::terminal) {
      EXPECT_EQ(pipe2(output.data(), O_CLOEXEC), 0);
      EXPECT_EQ(pipe2(input.data(), O_CLOEXEC), 0);
    }
    if (place == Place::unreadPipe) close(output[0]);
    pid_ = place != Place::terminal ? fork() : forkpty(&output_, nullptr, nullptr, nullptr);
    if (pid_ == 0) {
      if (place != Place::terminal) {
        dup2(input[0], STDIN_FILENO);
        dup2(output[1], STDOUT_FILENO);
        dup2(errors == Errors::printed
                 ? output[1]
                 : open((folder / "errors").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600),
             STDERR_FILENO);
      }
      for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
      if (chdir(folder.c_str()) == 0) execv(arguments.front(), arguments.data());
      _exit(127);
    }
    if (place == Place::terminal) return;
    close(output[1]);
    close(input[0]);
    if (place == Place::pipe) output_ = output[0];
    input_ = input[1];
  }
  ~RunningProgram() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    closeTerminal();
    if (input_ >= 0) close(input_);
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits until it has printed a text.
  void awaitText(const std::string& text) {
    while (printed_.find(text) == printed_.npos)
      if (!read()) FAIL() << "ended without '" << text << "':\n" << printed_;
  }
  /// Waits until it has written something to a file.
  void awaitFile(const fs::path& file) const {
    std::error_code missing;
    for (int i = 0; i < 6000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds{10}))
      if (const auto size = fs::file_size(file, missing); !missing && size > 0) return;
    FAIL() << file << " is not written";
  }
  void type(const std::string& line) const {
    ASSERT_EQ(write(input_, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  void send(int signal) const { ::kill(pid_, signal); }
  /// Leaves it the memory that it has, and no more.
  void takeMemory() const {
    std::ifstream file{"/proc/" + std::to_string(pid_) + "/statm"};
    rlim_t pages = 0;
    file >> pages;
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    const rlimit limit{bytes, bytes};
    EXPECT_EQ(prlimit(pid_, RLIMIT_AS, &limit, nullptr), 0);
  }
  /// Kills the program that it has started with an argument.
  void killChild(const std::string& argument) const {
    const std::string number = std::to_string(pid_);
    std::ifstream children{"/proc/" + number + "/task/" + number + "/children"};
    for (pid_t child = 0; children >> child;) {
      std::ifstream line{"/proc/" + std::to_string(child) + "/cmdline"};
      const std::string words{std::istreambuf_iterator<char>{line}, {}};
      if (words.find('\0' + argument + '\0') != words.npos) ::kill(child, SIGKILL);
    }
  }
  void closeTerminal() { closeOutput(); }
  /// Reads nothing that it prints any more.
  void closeOutput() {
    if (output_ >= 0) close(std::exchange(output_, -1));
  }
  /// Waits for its end, and returns its exit status; less than 0 if a signal ended it.
  int end() {
    while (output_ >= 0 && read()) {
    }
    int status = 0;
    waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  const std::string& printed() const { return printed_; }

 private:
  bool read() {
    std::array<char, 4096> bytes;
    const auto count = ::read(output_, bytes.data(), bytes.size());
    if (count > 0) printed_.append(bytes.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  pid_t pid_ = -1;
  int output_ = -1, input_ = -1;
  std::string printed_;
};

std::string contentOf(const fs::path& file) {
  const auto content = readFile(file.string());
  EXPECT_TRUE(content) << content.error().text();
  return content ? *content : "";
}

void expectWholeLog(const fs::path& file) {
  const auto log = McapReader::open(file.string());
  ASSERT_TRUE(log) << log.error().text();
  EXPECT_TRUE(log->complete()) << file;
  EXPECT_TRUE(log->damage().empty()) << log->damage().front().text();
}

class SignalsTest : public testing::Test {
 protected:
  SignalsTest() {
    write("begin.con", "run 2\necho playing\n");
    write("record.con",
          "robot red3\nlog start\nfilm start film.mp4 field\nrun 1\necho recording\nrun 100000\n");
  }

  void write(const std::string& name, const std::string& content) const {
    ASSERT_TRUE(writeFile(path(name), content));
  }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  /// A match that says when two seconds of it have passed.
  std::vector<std::string> play(const std::string& minutes = "60") const {
    return {"simgt", "play",      "--minutes", minutes,
            "--out", path("out"), "--script",  path("begin.con")};
  }
  std::vector<std::string> console(const std::string& script) const {
    return {"simgt", "console", scene, "--script", path(script)};
  }
  MatchSummary summary() const {
    MatchSummary match;
    EXPECT_TRUE(readJson(contentOf(path("out/match.json")), "match.json", match));
    return match;
  }
  void expectInterruptedMatch() const {
    const MatchSummary match = summary();
    EXPECT_TRUE(match.interrupted);
    EXPECT_GE(match.duration.ms, 2000);
    EXPECT_LT(match.duration.ms, 60 * 60'000);
    EXPECT_THAT(contentOf(path("out/report.html")), HasSubstr("Blue, interrupted at "));
    EXPECT_FALSE(contentOf(path("out/times.json")).empty());
    for (const char* robot : {"red1", "red2", "red3", "red4", "blue1", "blue2", "blue3", "blue4"})
      expectWholeLog(path(std::string{"out/"} + robot + ".mcap"));
    EXPECT_FALSE(fs::exists(path("out/.lock")));
  }
  void expectWholeRecording() const {
    EXPECT_THAT(contentOf(path("out/film.mp4")), HasSubstr("moov"));
    expectWholeLog(path("out/logs/red3.interrupted.mcap"));
  }

  static inline const std::string scene = fs::absolute("scenes/one-robot.scene").string();
  const TemporaryFolder folder;
};

class Signal : public SignalsTest, public testing::WithParamInterface<int> {};

TEST_P(Signal, EndsAMatchWithAllThatWasPlayed) {
  RunningProgram match{folder.path(), play()};
  match.awaitText("playing\n");
  match.send(GetParam());
  EXPECT_EQ(match.end(), 128 + GetParam()) << match.printed();
  EXPECT_THAT(match.printed(), HasSubstr("simgt: interrupted at 0:"));
  expectInterruptedMatch();
}

TEST_P(Signal, EndsARecordingAndAFilm) {
  RunningProgram recording{folder.path(), console("record.con")};
  recording.awaitText("recording\n");
  recording.send(GetParam());
  EXPECT_EQ(recording.end(), 128 + GetParam()) << recording.printed();
  EXPECT_THAT(recording.printed(), HasSubstr("messages in out/logs/red3.interrupted.mcap"));
  expectWholeRecording();
}

TEST_F(SignalsTest, WhatIsRecordedStaysBesideTheLogThatWasSaved) {
  write("record.con",
        "robot red3\nlog start\nrun 1\nlog save mine/log.mcap\nrun 1\necho more\nrun 100000\n");
  RunningProgram recording{folder.path(), console("record.con")};
  recording.awaitText("more\n");
  recording.send(SIGTERM);
  EXPECT_EQ(recording.end(), 128 + SIGTERM) << recording.printed();
  expectWholeLog(path("mine/log.interrupted.mcap"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_P(Signal, EndsAConsoleThatWaitsForALine) {
  RunningProgram waiting{folder.path(), {"simgt", "console", scene}};
  waiting.type("echo ready\n");
  waiting.awaitText("ready\n");
  waiting.send(GetParam());
  EXPECT_EQ(waiting.end(), 128 + GetParam()) << waiting.printed();
}

TEST_P(Signal, EndsTheWorkbenchWithItsRecordingAndItsFilm) {
  if (!fs::exists(programFolder() + "/robotcontrol")) GTEST_SKIP() << "there is no robotcontrol";
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  RunningProgram workbench{
      folder.path(),
      {"robotcontrol", scene, "--settings", path("settings"), "--script", path("record.con")}};
  workbench.awaitFile(path("out/film.mp4.part"));
  workbench.send(GetParam());
  EXPECT_EQ(workbench.end(), 128 + GetParam()) << workbench.printed();
  expectWholeRecording();
}

TEST_P(Signal, EndsExperimentsWithTheFiguresOfTheJobsThatAreDone) {
  RunningProgram experiment{
      folder.path(),
      {"experiment", "--seeds", "1..1000", "--only", "localization.robustness.bench", "--set",
       "trouble=none", "--set", "minutes=0.1", "--json", path("experiments.json")}};
  experiment.awaitText("3/1000 ");
  experiment.send(GetParam());
  EXPECT_EQ(experiment.end(), 128 + GetParam()) << experiment.printed();
  EXPECT_THAT(experiment.printed(), HasSubstr("experiment: Interrupted: "));
  EXPECT_THAT(contentOf(path("experiments.json")), HasSubstr("\"n\": "));
  EXPECT_THAT(contentOf(path("experiments.html")), HasSubstr(" of 1000 jobs are done.</p>"));
  const std::string results = contentOf(path("experiments.jsonl"));
  EXPECT_TRUE(results.ends_with("}\n"));
}

INSTANTIATE_TEST_SUITE_P(Of, Signal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_P(Signal, LeavesNoHalfLog) {
  auto writer = McapWriter::open(path("long.mcap"), {false});
  ASSERT_TRUE(writer);
  Random random{1};
  Text text;
  for (int i = 0; i < 64; ++i) {
    text.text.resize(1 << 20);
    for (char& c : text.text) c = static_cast<char>(random());
    writer->write("/Text", Time{i}, text);
  }
  ASSERT_TRUE(writer->close());
  write("cut.mcap", "what was there");
  RunningProgram cut{folder.path(), {"gtlog", "cut", path("long.mcap"), path("cut.mcap")}};
  const auto size = [&] {
    std::error_code none;
    const auto bytes = fs::file_size(path("cut.mcap.part"), none);
    return none ? 0 : bytes;
  };
  // It may have ended before it is looked at: then it is whole.
  for (int i = 0; i < 100 && size() == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  cut.send(GetParam());
  if (cut.end() == 0)
    expectWholeLog(path("cut.mcap"));
  else
    EXPECT_EQ(contentOf(path("cut.mcap")), "what was there");
}

TEST_F(SignalsTest, AClosedTerminalEndsAMatchWithAllThatWasPlayed) {
  RunningProgram match{folder.path(), play(), Place::terminal};
  match.awaitText("playing");
  match.closeTerminal();
  EXPECT_EQ(match.end(), 128 + SIGHUP);
  expectInterruptedMatch();
}

TEST_F(SignalsTest, AClosedTerminalEndsAConsoleInWhichSomebodyTypes) {
  RunningProgram typed{folder.path(), {"simgt", "console", scene}, Place::terminal};
  typed.awaitText("simgt> ");
  typed.closeTerminal();
  EXPECT_EQ(typed.end(), 128 + SIGHUP);
}

TEST_F(SignalsTest, ASignalEndsTheScriptOfAMatch) {
  write("begin.con", "run 1\necho playing\nrun 100000\necho never\n");
  RunningProgram match{folder.path(), play()};
  match.awaitText("playing\n");
  match.send(SIGTERM);
  EXPECT_EQ(match.end(), 128 + SIGTERM) << match.printed();
  EXPECT_THAT(match.printed(), Not(HasSubstr("never")));
  EXPECT_TRUE(summary().interrupted);
}

/// As `simgt play | head -1` does.
TEST_F(SignalsTest, WhoReadsNoMoreEndsAMatchWithAllThatWasPlayed) {
  RunningProgram match{folder.path(), play(), Place::pipe, Errors::file};
  match.awaitText("playing\n");
  match.closeOutput();
  EXPECT_EQ(match.end(), 128 + SIGPIPE);
  EXPECT_THAT(contentOf(path("errors")), StartsWith("simgt: interrupted at 0:"));
  expectInterruptedMatch();
}

TEST_F(SignalsTest, WhoReadsNoMoreEndsARecordingAndAFilm) {
  write(
      "record.con",
      "robot red3\nlog start\nfilm start film.mp4 field\nrun 1\necho recording\nrun 1\necho more\n"
      "run 100000\n");
  RunningProgram recording{folder.path(), console("record.con"), Place::pipe, Errors::file};
  recording.awaitText("recording\n");
  recording.closeOutput();
  EXPECT_EQ(recording.end(), 128 + SIGPIPE);
  EXPECT_THAT(contentOf(path("errors")), Not(HasSubstr("ipe")));
  expectWholeRecording();
}

/// Programs that write nothing but what is read end at once, without a word.
TEST_F(SignalsTest, WhoReadsNoMoreEndsOtherProgramsQuietly) {
  auto writer = McapWriter::open(path("long.mcap"), {false});
  ASSERT_TRUE(writer);
  for (int i = 0; i < 20'000; ++i) writer->write("/Text", Time{i}, Text{std::string(100, 'x')});
  ASSERT_TRUE(writer->close());
  const std::string small = fs::absolute("tests/fuzz/corpus/mcap/small.mcap").string();
  const std::string test = fs::absolute("tests/fuzz/corpus/xtest/sound.xtest").string();
  for (const auto& command : std::vector<std::vector<std::string>>{
           {"gtlog", "show", path("long.mcap")},
           {"gtlog", "list", small},
           {"simgt", "commands"},
           {"simgt", "layout"},
           {"xabsl", "test", test},
           {"motionnet", "list"},
           {"experiment", "list", "--seeds", "1..1000", "--only", "match"}}) {
    RunningProgram program{folder.path(), command, Place::unreadPipe, Errors::file};
    const int status = program.end();
    EXPECT_TRUE(status == -SIGPIPE || status == 128 + SIGPIPE) << command[0] << " " << status;
    EXPECT_EQ(contentOf(path("errors")), "") << command[0];
  }
}

TEST_F(SignalsTest, AWrongLineOfTheScriptCostsNothingThatWasPlayed) {
  write("begin.con", "run 3\nnonsense\n");
  RunningProgram wrong{folder.path(), play()};
  EXPECT_EQ(wrong.end(), 2);
  EXPECT_THAT(wrong.printed(), HasSubstr("simgt: " + path("begin.con") + ":2: nonsense: "));
  expectInterruptedMatch();
  write("begin.con", "run 3\nexpect time > 5\n");
  RunningProgram disappointed{folder.path(), play()};
  EXPECT_EQ(disappointed.end(), 1) << disappointed.printed();
  expectInterruptedMatch();
}

/// A match that ends with a team's program leaves what was played, marked with what happened.
TEST_F(SignalsTest, AProgramOfATeamThatDiesCostsNothingThatWasPlayed) {
  std::vector<std::string> command = play();
  command.insert(command.end(), {"--blue", "program:" + programFolder() + "/gtrobot-robot"});
  RunningProgram match{folder.path(), command};
  match.awaitText("playing\n");
  match.killChild("blue4");
  EXPECT_EQ(match.end(), 2) << match.printed();
  const std::string error = "blue4: its program was ended by signal 9";
  EXPECT_THAT(match.printed(), HasSubstr("simgt: " + error + "\n"));
  const MatchSummary summary = this->summary();
  EXPECT_TRUE(summary.interrupted);
  EXPECT_GE(summary.duration, Time{2000});
  ASSERT_FALSE(summary.events.empty());
  EXPECT_EQ(summary.events.back().kind, "failure");
  EXPECT_EQ(summary.events.back().text, error);
  EXPECT_EQ(summary.events.back().time, summary.duration);
  EXPECT_THAT(contentOf(path("out/report.html")), HasSubstr("Blue, interrupted at "));
  for (const char* robot : {"red1", "red2", "red3", "red4"})
    expectWholeLog(path(std::string{"out/"} + robot + ".mcap"));
}

/// Whatever there is no memory for, the program ends in order.
TEST_F(SignalsTest, AMatchWithoutMoreMemoryEndsWithOneLine) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  RunningProgram match{folder.path(), play()};
  match.awaitText("playing\n");
  match.takeMemory();
  match.send(SIGTERM);
  const int status = match.end();
  EXPECT_TRUE(status == 2 || status == 128 + SIGTERM) << status << "\n" << match.printed();
  EXPECT_THAT(match.printed(), Not(HasSubstr("terminate called")));
  if (status == 2) {
    EXPECT_THAT(match.printed(), HasSubstr("not enough memory\n"));
  }
}

TEST_F(SignalsTest, TwoMatchesDoNotShareAFolder) {
  RunningProgram first{folder.path(), play()};
  first.awaitText("playing\n");
  RunningProgram second{folder.path(), play("0.02")};
  EXPECT_EQ(second.end(), 2);
  EXPECT_EQ(second.printed(),
            "simgt: " + path("out") + ": is being written by another program or match\n");
  first.send(SIGTERM);
  EXPECT_EQ(first.end(), 128 + SIGTERM) << first.printed();
  expectInterruptedMatch();
}

TEST_F(SignalsTest, TwoExperimentsDoNotShareTheirResults) {
  const std::vector<std::string> command{
      "experiment",   "--seeds", "1..1000",     "--only", "localization.robustness.bench", "--set",
      "trouble=none", "--set",   "minutes=0.1", "--json", path("experiments.json")};
  RunningProgram first{folder.path(), command};
  first.awaitText("1/1000 ");
  RunningProgram second{folder.path(), command};
  EXPECT_EQ(second.end(), 2);
  EXPECT_EQ(second.printed(), "experiment: " + path("experiments.jsonl") +
                                  ": is being written by another program or match\n");
  first.send(SIGTERM);
  EXPECT_EQ(first.end(), 128 + SIGTERM) << first.printed();
}

TEST_F(SignalsTest, ALogThatCannotBeWrittenIsToldAtOnceAndCostsNothingElse) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  fs::create_directory(path("out"));
  fs::create_symlink("/dev/full", path("out/red1.mcap"));
  RunningProgram match{folder.path(), play("0.02")};
  EXPECT_EQ(match.end(), 2) << match.printed();
  const std::string error =
      path("out/red1.mcap") + ": cannot be written: No space left on device\n";
  const auto told = match.printed().find(error);
  const auto score = match.printed().find("Final score");
  ASSERT_NE(score, std::string::npos) << match.printed();
  EXPECT_LT(told, score) << match.printed();
  EXPECT_TRUE(match.printed().ends_with("simgt: " + error)) << match.printed();
  EXPECT_FALSE(summary().interrupted);
  EXPECT_THAT(contentOf(path("out/report.html")), HasSubstr("GT2003 match report"));
  expectWholeLog(path("out/blue1.mcap"));
}

TEST_F(SignalsTest, AFolderThatIsRemovedIsToldAtOnceAndCostsTheLogsOnly) {
  RunningProgram match{folder.path(), play("0.02")};
  match.awaitText("playing\n");
  fs::remove_all(path("out"));
  EXPECT_EQ(match.end(), 2) << match.printed();
  const auto told = match.printed().find("red1.mcap: was removed while it was written\n");
  EXPECT_LT(told, match.printed().find("Final score")) << match.printed();
  EXPECT_FALSE(summary().interrupted);
}

}  // namespace
}  // namespace gt
