#include "match/teams/TeamProgram.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "base/File.h"
#include "base/Program.h"
#include "base/TemporaryFolder.h"
#include "match/teams/TeamFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// A repository whose program of a robot is a line of text.
class TeamProgramTest : public ::testing::Test {
 protected:
  TeamProgramTest() {
    for (const char* part : {"behavior", "config", "layouts", "models", "motions", "scenes"})
      write(std::string{part} + "/some.file", "");
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\n"
          "project(robots NONE)\n"
          "add_custom_target(gtrobot-robot COMMAND ${CMAKE_COMMAND} -E copy\n"
          "  ${PROJECT_SOURCE_DIR}/program ${CMAKE_BINARY_DIR}/bin/gtrobot-robot VERBATIM)\n");
    write("program", "first\n");
    run({"git", "init", "--quiet"});
    old = commit();
    write("src/robot/linux/Lockstep.h", "");
    first = commit();
    write("program", "second\n");
    second = commit();
    EXPECT_EQ(setenv("XDG_CACHE_HOME", cache.path().c_str(), 1), 0);
  }
  ~TeamProgramTest() override { unsetenv("XDG_CACHE_HOME"); }

  void write(const std::string& name, const std::string& text) const {
    const fs::path file = folder.path() / name;
    fs::create_directories(file.parent_path());
    ASSERT_TRUE(writeFile(file.string(), text));
  }
  std::string run(std::vector<std::string> git) const {
    git.insert(git.begin() + 1, {"-C", folder.path(), "-c", "user.name=n", "-c", "user.email=e"});
    const auto done = runProgram(git);
    EXPECT_TRUE(done && done->status == 0) << (done ? done->errors : done.error().text());
    return done->output.substr(0, done->output.find('\n'));
  }
  std::string commit() const {
    run({"git", "add", "--all"});
    run({"git", "commit", "--quiet", "--message", "next"});
    return run({"git", "rev-parse", "HEAD"});
  }
  std::string errorOf(const std::string& team) const {
    const auto program = teamProgram(team, root);
    return program ? "" : program.error().text();
  }

  TemporaryFolder folder, cache;
  DataRoot root{folder.path().string()};
  std::string old, first, second;
};

TEST_F(TeamProgramTest, BuildsACommitOnce) {
  const auto program = teamProgram("commit:" + first.substr(0, 8) + ":kalman", root);
  ASSERT_TRUE(program) << program.error().text();
  EXPECT_EQ(program->file, cache.path() / "gt2003/teams" / first / "gtrobot-robot");
  EXPECT_EQ(*readFile(program->file), "first\n");
  EXPECT_EQ(*readFile(program->root.path("program")), "first\n") << "the files of that commit";
  EXPECT_EQ(program->team, "kalman");
  EXPECT_FALSE(fs::exists(program->root.path("build"))) << "only what is needed is kept";
  ASSERT_TRUE(writeFile(program->file, "as it was left"));
  const auto again = teamProgram("commit:" + first, root);
  ASSERT_TRUE(again);
  EXPECT_EQ(*readFile(again->file), "as it was left");
  const auto other = teamProgram("commit:HEAD", root);
  ASSERT_TRUE(other);
  EXPECT_EQ(*readFile(other->file), "second\n");
}

TEST_F(TeamProgramTest, NamesACommitForEver) {
  const auto team = resolvedTeam("commit:HEAD~1:kalman", root);
  ASSERT_TRUE(team);
  EXPECT_EQ(*team, "commit:" + first + ":kalman");
  EXPECT_EQ(*resolvedTeam("program:x", root), "program:x");
  EXPECT_TRUE(namesProgram("commit:x") && namesProgram("program:x"));
  EXPECT_FALSE(namesProgram("kalman-study"));
}

TEST_F(TeamProgramTest, AJobNamesItByItsCommit) {
  const auto version = teamVersion("commit:HEAD~1:kalman", root);
  ASSERT_TRUE(version) << version.error().text();
  EXPECT_EQ(*version, "commit:" + first + ":kalman");
  EXPECT_EQ(*teamOfVersion(*version, root), *version);
  const auto errorOfVersion = [&](const std::string& team) {
    const auto wrong = teamVersion(team, root);
    return wrong ? "" : wrong.error().text();
  };
  EXPECT_THAT(errorOfVersion("commit:HEAD:../team"), EndsWith("commit's folder teams"));
  EXPECT_EQ(errorOfVersion("commit:none"), "commit:none: is no commit of the repository");
  EXPECT_THAT(errorOfVersion("program:x"), EndsWith("may change: expected commit:REVISION"));
}

TEST_F(TeamProgramTest, AFailedBuildIsReportedAndDoneAgain) {
  write("CMakeLists.txt", "message(FATAL_ERROR \"no such thing\")\n");
  const std::string broken = commit();
  const std::string error = errorOf("commit:" + broken);
  EXPECT_THAT(error, HasSubstr("cannot be built: 'cmake' failed, see "));
  const auto log = readFile(error.substr(error.find("see ") + 4));
  ASSERT_TRUE(log);
  EXPECT_THAT(*log, HasSubstr("no such thing"));
  EXPECT_EQ(errorOf("commit:" + broken), error);
}

TEST_F(TeamProgramTest, MistakesAreToldInOneLine) {
  EXPECT_EQ(errorOf("commit:nothing"), "commit:nothing: is no commit of the repository");
  EXPECT_EQ(errorOf("commit:--help"), "commit:--help: is no commit of the repository");
  EXPECT_THAT(errorOf("commit:" + old), HasSubstr("its robots cannot play in lockstep"));
  EXPECT_EQ(errorOf("program:nowhere"), "nowhere: is no program");
  EXPECT_THAT(errorOf("program:" + folder.path().string()), EndsWith("is no program"));
  EXPECT_EQ(errorOf("program:/bin/sh"), "/bin/sh: belongs to no tree with a configuration");
}

}  // namespace
}  // namespace gt
