#include "match/teams/TeamFolder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "base/File.h"
#include "representations/motion/MotionNet.h"
#include "robot/ProjectVersion.h"
#include "robot/Robot.h"
#include "robot/SetupFiles.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

class TeamFolderTest : public ::testing::Test {
 protected:
  /// Adds a file to the team.
  void write(const std::string& name, std::string_view text) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    ASSERT_TRUE(writeFile(file.string(), text));
  }
  std::string team() const { return folder_.path().string(); }
  std::string errorOf(const std::string& folder) const {
    const auto opened = TeamFolder::open(folder, {});
    return opened ? "" : opened.error().text();
  }
  /// What is wrong with the team's configuration, with the team's folder as TEAM.
  std::string configurationError() const {
    const auto opened = TeamFolder::open(team(), {});
    EXPECT_TRUE(opened) << opened.error().text();
    const auto configuration = loadConfiguration((*opened)->paths());
    if (configuration) return "";
    std::string text = (*opened)->named(configuration.error()).text();
    for (std::size_t at = 0; (at = text.find(team())) != text.npos;)
      text.replace(at, team().size(), "TEAM");
    return text;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TeamFolderTest, LiesOverTheProjectsFiles) {
  write("config/modules/SelfLocator.Kalman.cfg", "slip 0.4\n");
  write("README.md", "about the team");
  const auto opened = TeamFolder::open(team(), {});
  ASSERT_TRUE(opened) << opened.error().text();
  const auto own = loadConfiguration({}), other = loadConfiguration((*opened)->paths());
  ASSERT_TRUE(other) << other.error().text();
  const auto files = [](const Configuration& configuration) {
    std::map<std::string, std::string> texts;
    for (const auto& file : configuration.parameters)
      texts[file.task + "." + file.solution] = file.text;
    return texts;
  };
  auto expected = files(**own);
  expected["SelfLocator.Kalman"] = "slip 0.4\n";
  EXPECT_EQ(files(**other), expected);
  EXPECT_EQ((*other)->solutions.size(), (*own)->solutions.size());
  EXPECT_EQ((*other)->get<MotionNet>().motions.size(), (*own)->get<MotionNet>().motions.size());
  EXPECT_FALSE(fs::exists("config/modules/SelfLocator.Kalman.cfg"))
      << "the project's are as before";
}

/// One line changes one task; the others stay as the project has chosen them.
TEST_F(TeamFolderTest, ChangesOnlyTheTasksThatItNames) {
  write("config/modules.cfg", "BallLocator BallChallenge\n");
  const auto opened = TeamFolder::open(team(), {});
  ASSERT_TRUE(opened) << opened.error().text();
  const auto chosen = [](const std::shared_ptr<const Configuration>& configuration) {
    std::map<std::string, std::string> solutions;
    for (const auto& choice : configuration->solutions) solutions[choice.task] = choice.solution;
    return solutions;
  };
  auto expected = chosen(*loadConfiguration({}));
  EXPECT_EQ(expected.at("SelfLocator"), "Kalman");
  expected["BallLocator"] = "BallChallenge";
  const auto configuration = loadConfiguration((*opened)->paths());
  ASSERT_TRUE(configuration) << configuration.error().text();
  EXPECT_EQ(chosen(*configuration), expected);
  EXPECT_EQ((*configuration)->solutions.size(), expected.size()) << "each task once";
}

/// A layout without most of the project's tasks: those that the team does not name need not be
/// there, its own must.
TEST_F(TeamFolderTest, PlaysALayoutWithOtherTasks) {
  const auto makes = [&](const std::string& folder) {
    const auto opened = TeamFolder::open(folder, {});
    EXPECT_TRUE(opened) << opened.error().text();
    RobotSetup setup;
    setup.configuration = *loadConfiguration((*opened)->paths());
    setup.layout = *loadLayout("layouts/sensor-behavior.layout");
    const auto robot = Robot::make(setup);
    return robot ? "" : robot.error().text();
  };
  EXPECT_EQ(makes("teams/sensor-behavior"), "");
  write("config/modules.cfg", "SelfLocator GT2003\n");
  EXPECT_THAT(makes(team()), ::testing::HasSubstr("no process solves this task"));
}

TEST_F(TeamFolderTest, HasErrorsInItsOwnFiles) {
  write("config/modules.cfg", "SelfLocator Best\n");
  EXPECT_THAT(configurationError(), ::testing::StartsWith("TEAM/config/modules.cfg:1: "));
  write("config/modules.cfg", "");
  EXPECT_EQ(configurationError(), "");
  write("behavior/GT2003.xabsl", "agent what\n");
  EXPECT_THAT(configurationError(),
              ::testing::ContainsRegex("^TEAM/behavior/GT2003.xabsl:[0-9]+:[0-9]+: "));
}

/// Also where a sentence names a second file.
TEST_F(TeamFolderTest, NamesItsOwnFilesInSentences) {
  const auto changed = [&](const std::string& file, std::string_view from, std::string_view to) {
    std::string text = *readFile(file);
    const auto at = text.find(from);
    ASSERT_NE(at, text.npos);
    write(file, text.replace(at, from.size(), to));
  };
  changed("behavior/symbols/kick_symbols.xabsl", "  float input kick.facing",
          "  float input kick.nothing;\n  float input kick.facing");
  changed("behavior/options/ball/search_ball.xabsl", "kick.time_since_last", "kick.nothing");
  EXPECT_THAT(configurationError(),
              ::testing::MatchesRegex(
                  "TEAM/behavior/symbols/kick_symbols.xabsl:.*, needed by option "
                  "search_ball .TEAM/behavior/options/ball/search_ball.xabsl:[0-9]+.*"));
}

TEST_F(TeamFolderTest, RefusesFoldersOfNoTeam) {
  EXPECT_EQ(errorOf("nowhere"), "nowhere: is no team: there is no such folder");
  EXPECT_EQ(errorOf(team()),
            team() + ": is no team: it has none of the folders behavior, config, motions");
  write("config/modules.cfg", "");
  EXPECT_EQ(errorOf(team()), "");
  write("configs/log.cfg", "");
  EXPECT_EQ(errorOf(team()), team() +
                                 ": is no team: expected folders behavior, config, motions; not "
                                 "'configs'");
}

TEST_F(TeamFolderTest, VersionsNameWhatTheFilesAre) {
  write("config/modules.cfg", "SelfLocator GT2003\n");
  const auto first = teamVersion(team(), {});
  ASSERT_TRUE(first) << first.error().text();
  EXPECT_THAT(*first, ::testing::StartsWith(fs::canonical(team()).string() + "@"));
  EXPECT_EQ(*teamVersion(team() + "/config/..", {}), *first);
  EXPECT_EQ(*teamOfVersion(*first, {}), fs::canonical(team()));
  write("config/modules.cfg", "SelfLocator Kalman\n");
  const auto changed = teamOfVersion(*first, {});
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().text(), ::testing::HasSubstr("has changed since; it is @"));
  EXPECT_NE(*teamVersion(team(), {}), *first);
  write("config/modules.cfg", "SelfLocator GT2003\n");
  EXPECT_EQ(*teamVersion(team(), {}), *first);
  write("config/log.cfg", "");
  EXPECT_NE(*teamVersion(team(), {}), *first) << "an empty file counts";
}

/// Whoever edits the project's own files makes other jobs of them.
TEST_F(TeamFolderTest, TheVersionOfTheProjectNamesItsFiles) {
  for (const char* folder : {"behavior", "config", "layouts", "models", "motions", "scenes"})
    write(std::string{folder} + "/a.txt", "as it was");
  const DataRoot root{team()};
  const auto first = projectVersion(root);
  ASSERT_TRUE(first) << first.error().text();
  EXPECT_THAT(*first, ::testing::StartsWith(commit() + "+"));
  for (const char* folder : {"behavior", "config", "layouts", "models", "motions", "scenes"}) {
    const std::string file = std::string{folder} + "/a.txt";
    write(file, "edited");
    EXPECT_NE(*projectVersion(root), *first) << file;
    write(file, "as it was");
    EXPECT_EQ(*projectVersion(root), *first) << file;
  }
  write("out/match.json", "what programs write");
  EXPECT_EQ(*projectVersion(root), *first);
}

TEST_F(TeamFolderTest, TeamsOfTheRootHaveShortNames) {
  const auto version = teamVersion("kalman-study", {});
  ASSERT_TRUE(version) << version.error().text();
  EXPECT_THAT(*version, ::testing::MatchesRegex("kalman-study@[0-9a-f]{16}"));
  EXPECT_EQ(*teamVersion("teams/kalman-study", {}), *version);
  EXPECT_EQ(*teamOfVersion(*version, {}), "teams/kalman-study");
  EXPECT_EQ(*teamOfVersion("kalman-study", {}), "teams/kalman-study");
  EXPECT_EQ(*teamVersion("GT2003", {}), "GT2003");
  EXPECT_EQ(*teamOfVersion("GT2003", {}), "");
  EXPECT_EQ(teamVersion("kalman-studies", {}).error().text(),
            "kalman-studies: is no team: there is no such folder");
}

/// The project's teams can play.
TEST_F(TeamFolderTest, TheProjectsTeamsAreSound) {
  for (const auto& entry : fs::directory_iterator{"teams"}) {
    const auto opened = TeamFolder::open(entry.path().string(), {});
    ASSERT_TRUE(opened) << opened.error().text();
    const Findings findings = checkConfiguration((*opened)->paths(), allModules());
    EXPECT_TRUE(findings.empty()) << entry.path() << findings.firstError().error().text();
  }
}

}  // namespace
}  // namespace gt
