// Teams whose robots are programs in lockstep with the simulation.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/Program.h"
#include "base/TemporaryFolder.h"
#include "match/TestMatch.h"
#include "support/ProgramFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string ourProgram = "program:" + programFolder() + "/gtrobot-robot";

class TeamProgramsTest : public ::testing::Test {
 protected:
  static std::unique_ptr<Match> make(const std::string& red, const std::string& blue,
                                     std::size_t threads = 1) {
    MatchOptions options;
    options.scene = "tests/support/short.scene";
    options.minutes = 0.1;
    options.seed = 5;
    options.threads = threads;
    options.red = red;
    options.blue = blue;
    auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    return std::move(*match);
  }
  /// What a match leaves: its summary and a hash of its last state. Robots in other programs do not
  /// tell what they decide, so what is counted by roles and plans is left out.
  static std::string play(const std::string& red, const std::string& blue,
                          std::size_t threads = 1) {
    const auto match = make(red, blue, threads);
    while (!isOver(*match)) match->step();
    const auto done = match->teamFailure();
    EXPECT_TRUE(done) << done.error().text();
    MatchSummary summary = match->summary();
    std::erase_if(summary.play, [](const PlayFigure& figure) {
      return figure.name.find(".role") != figure.name.npos ||
             figure.name.find(".striker") != figure.name.npos ||
             figure.name.find("Planned") != figure.name.npos;
    });
    return jsonText(summary) + std::to_string(match->simulation().fingerprint());
  }
  /// The programs that this one has started.
  static std::vector<pid_t> children() {
    const std::string own = std::to_string(getpid());
    std::ifstream file{"/proc/" + own + "/task/" + own + "/children"};
    std::vector<pid_t> all;
    for (pid_t id = 0; file >> id;) all.push_back(id);
    return all;
  }
  /// A tree with a program that is a script of the shell.
  std::string script(const std::string& commands) const {
    for (const char* part : {"behavior", "config", "layouts", "models", "motions", "scenes"})
      fs::create_directories(folder.path() / part);
    const fs::path file = folder.path() / "script";
    EXPECT_TRUE(writeFile(file.string(), "#!/bin/sh\n" + commands + "\n"));
    fs::permissions(file, fs::perms::owner_all);
    return "program:" + file.string();
  }

  TemporaryFolder folder;
};

TEST_F(TeamProgramsTest, PlayTheSameMatchAsInOneProgram) {
  const std::string expected = play("", "");
  EXPECT_EQ(play(ourProgram, ourProgram), expected);
  EXPECT_EQ(play("", ourProgram, 2), expected);
}

TEST_F(TeamProgramsTest, MayHaveFilesOfTheirOwn) {
  const std::string expected = play("kalman-study", "");
  EXPECT_EQ(play(ourProgram + std::string{":kalman-study"}, ""), expected);
  EXPECT_NE(play("", ""), expected) << "or the test shows nothing";
}

TEST_F(TeamProgramsTest, WhatIsWrongIsReportedWithItsFile) {
  fs::create_directories(folder.path() / "config/modules");
  const std::string file = (folder.path() / "config/modules/SelfLocator.Kalman.cfg").string();
  ASSERT_TRUE(writeFile(file, "slip 0.4\nslop 1\n"));
  MatchOptions options;
  options.blue = ourProgram + (":" + folder.path().string());
  const auto match = Match::make(options);
  ASSERT_FALSE(match);
  EXPECT_THAT(match.error().text(), HasSubstr("SelfLocator.Kalman.cfg:2: slop"));
  EXPECT_EQ(match.error().file, file);
}

TEST_F(TeamProgramsTest, AMatchEndsWithTheProgramOfARobot) {
  const auto match = make("", ourProgram);
  for (int i = 0; i < 10; ++i) match->step();
  ASSERT_EQ(children().size(), 4u);
  EXPECT_EQ(kill(children().at(1), SIGKILL), 0);
  while (!isOver(*match)) match->step();
  EXPECT_LT(match->time(), Time{1000});
  ASSERT_FALSE(match->teamFailure());
  EXPECT_EQ(match->teamFailure().error().text(), "blue2: its program was ended by signal 9");
}

TEST_F(TeamProgramsTest, AMatchEndsIfAProgramDoesNotAnswer) {
  MatchOptions options;
  options.red = ourProgram;
  options.patience = std::chrono::seconds{10};
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  (*match)->step();
  const std::vector<pid_t> programs = children();
  ASSERT_EQ(programs.size(), 4u);
  EXPECT_EQ(kill(programs[2], SIGSTOP), 0);
  while (!isOver(**match)) (*match)->step();
  ASSERT_FALSE((*match)->teamFailure());
  EXPECT_EQ((*match)->teamFailure().error().text(),
            "red3: its program has not answered for 10000 ms");
}

/// With files alone as with a program.
TEST_F(TeamProgramsTest, ThatAskForTheTruthAreRefused) {
  fs::create_directories(folder.path() / "config");
  const std::string file = (folder.path() / "config/modules.cfg").string();
  ASSERT_TRUE(writeFile(file, "BallLocator PIDSmoothed\nSelfLocator Oracled\n"));
  const std::string team = folder.path().string();
  for (const std::string& red : {team, ourProgram + (":" + team)}) {
    const TemporaryFolder out;
    const auto done = runProgram({programFolder() + "/simgt", "play", "--no-logs", "--minutes",
                                  "0.01", "--out", out.path(), "--red", red});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->status, 2);
    EXPECT_EQ(done->errors, "simgt: " + file +
                                ":2: SelfLocator: 'Oracled' reads OracledWorldState, which this "
                                "robot does not get\n");
  }
}

TEST_F(TeamProgramsTest, SimgtFailsInOneLine) {
  const std::string simgt = programFolder() + "/simgt";
  const auto done =
      runProgram({simgt, "play", "--no-logs", "--out", folder.path(), "--blue", script("exit 3")});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->status, 2);
  EXPECT_EQ(done->errors, "simgt: blue1: its program has ended with status 3\n");
}

}  // namespace
}  // namespace gt
