#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/Random.h"
#include "debug/Drawing.h"
#include "match/MatchSummary.h"
#include "streams/File.h"
#include "streams/Json.h"
#include "streams/Mcap.h"
#include "streams/TemporaryFolder.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

enum class Place { pipe, terminal };

/// A program of the build tree that runs in a folder, and what it prints.
class RunningProgram {
 public:
  RunningProgram(const fs::path& folder, std::vector<std::string> command,
                 Place place = Place::pipe) {
    command.front() = programFolder() + "/" + command.front();
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> output{}, input{};
    if (place == Place::pipe) {
      EXPECT_EQ(pipe2(output.data(), O_CLOEXEC), 0);
      EXPECT_EQ(pipe2(input.data(), O_CLOEXEC), 0);
    }
    pid_ = place == Place::pipe ? fork() : forkpty(&output_, nullptr, nullptr, nullptr);
    if (pid_ == 0) {
      if (place == Place::pipe) {
        dup2(input[0], STDIN_FILENO);
        dup2(output[1], STDOUT_FILENO);
        dup2(output[1], STDERR_FILENO);
      }
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
      if (chdir(folder.c_str()) == 0) execv(arguments.front(), arguments.data());
      _exit(127);
    }
    if (place == Place::terminal) return;
    close(output[1]);
    close(input[0]);
    output_ = output[0];
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
  void closeTerminal() {
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
