#include "robot/Deployment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class DeploymentTest : public ::testing::Test {
 protected:
  std::string path(const std::string& file) const { return (folder_.path() / file).string(); }
  Deployment dog() const {
    return {.config = "config",
            .player = {TeamColor::red, PlayerRole::striker1},
            .robot = "red3",
            .endpoint = "tcp://0.0.0.0:15003"};
  }
  /// What the programs of a robot read there.
  static void expectThere(const std::string& folder) {
    const auto player = loadPlayer(folder);
    ASSERT_TRUE(player) << player.error().text();
    EXPECT_EQ(player->teamColor, TeamColor::red);
    EXPECT_EQ(player->role, PlayerRole::striker1);
    const auto network = loadNetwork(folder);
    ASSERT_TRUE(network) << network.error().text();
    EXPECT_EQ(network->robot, "red3");
    EXPECT_EQ(network->tools, "tcp://0.0.0.0:15003");
    ConfigurationPaths paths;
    paths.config = folder;
    const auto configuration = loadConfiguration(paths);
    EXPECT_TRUE(configuration) << configuration.error().text();
    EXPECT_EQ(*readFile(folder + "/coltable.c64"), *readFile("config/coltable.c64"));
    EXPECT_TRUE(fs::exists(folder + "/modules"));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DeploymentTest, GoesToAFolder) {
  fs::create_directories(path("stick"));
  std::ofstream{path("stick/robot.key")} << "secret";
  std::ofstream{path("stick/player.cfg")} << "teamColor blue\n";
  const auto done = deploy(dog(), path("stick"));
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(*done, HasSubstr("playerRole striker1"));
  EXPECT_THAT(*done, HasSubstr("robot red3"));
  expectThere(path("stick"));
  EXPECT_EQ(*readFile(path("stick/robot.key")), "secret") << "what is not copied stays";
  std::ofstream{path("file")} << "no folder";
  const auto failed = deploy(dog(), path("file"));
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().text(), HasSubstr(path("file")));
}

TEST_F(DeploymentTest, ReplacesTheFilesOfALocation) {
  fs::create_directories(path("config/Padua"));
  fs::copy("config", path("config"), fs::copy_options::recursive);
  std::ofstream{path("config/Padua/player.cfg")} << "teamColor blue\n";
  Deployment dog = this->dog();
  dog.config = path("config");
  dog.location = "Padua";
  const auto done = deploy(dog, path("stick"));
  ASSERT_TRUE(done) << done.error().text();
  expectThere(path("stick"));
}

/// A program ssh that executes the command on this machine, unless the host is "nowhere".
TEST_F(DeploymentTest, GoesToAHostBySsh) {
  fs::create_directories(path("bin"));
  std::ofstream{path("bin/ssh")} << "#!/bin/sh\n"
                                    "while [ $# -gt 2 ]; do shift; done\n"
                                    "[ $1 = nowhere ] && { echo no route >&2; exit 255; }\n"
                                    "exec sh -c \"$2\"\n";
  fs::permissions(path("bin/ssh"), fs::perms::owner_all);
  const std::string before = std::getenv("PATH");
  setenv("PATH", (path("bin") + ":" + before).c_str(), 1);
  const auto done = deploy(dog(), "dog@lab:" + path("far/config"));
  const auto failed = deploy(dog(), "nowhere:" + path("other"));
  setenv("PATH", before.c_str(), 1);
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_THAT(*done, HasSubstr("playerRole striker1"));
  expectThere(path("far/config"));
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().text(), HasSubstr("nowhere: no route"));
  EXPECT_FALSE(deploy(dog(), "lab:folder; rm file"));
  EXPECT_FALSE(deploy(dog(), "-oProxyCommand=x:folder"));
}

}  // namespace
}  // namespace gt
