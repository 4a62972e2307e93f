#include "network/RobotList.h"

#include <sys/socket.h>
#include <sys/un.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "network/RouterSettings.h"
#include "streams/Config.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::TestFolder;

const RobotList::Places places{"127.0.0.1", 15000, ""};

std::string errorOf(const std::vector<std::string>& words) {
  const auto list = RobotList::parse(words, places);
  return list ? "" : list.error().text();
}

TEST(RobotList, TakesRobotsAsTheReportsScriptDid) {
  const auto list =
      RobotList::parse({"10.0.1.7", "10.0.2", "10", "11", "red1=ipc:///tmp/red1.Tools"}, places);
  ASSERT_TRUE(list) << list.error().text();
  const auto& robots = list->robots();
  ASSERT_EQ(robots.size(), 4u);
  EXPECT_FALSE(list->searches());
  EXPECT_EQ(robots[0].robot, "tcp://10.0.1.7:15000");
  EXPECT_EQ(robots[0].tools, "tcp://127.0.0.1:15007") << "15000 + least byte (report 5.3)";
  EXPECT_EQ(robots[2].name, "10.0.2.11");
  EXPECT_EQ(robots[3].robot, "ipc:///tmp/red1.Tools");
  EXPECT_EQ(robots[3].tools, "tcp://127.0.0.1:15301");
}

/// "start.bash -gm -release 10.0.1 10 11 12 13 20 21 22 23": Ai are the own robots, Bi the others.
TEST(RobotList, TheFirstFourAreATeam) {
  const auto list =
      RobotList::parse({"10.0.1", "10", "11", "12", "13", "20", "21", "22", "23"}, places);
  ASSERT_TRUE(list) << list.error().text();
  std::string teams;
  for (const RoutedRobot& robot : list->robots()) teams += robot.team;
  EXPECT_EQ(teams, "AAAABBBB");
}

TEST(RobotList, RefusesWhatIsNoRobot) {
  for (const char* wrong : {"", "red", "10.0.1.256", "1", "10.0.1.2.3", "=x", "10..1.2", "-1"})
    EXPECT_NE(errorOf({wrong}).find("is no robot"), std::string::npos) << wrong;
  EXPECT_NE(errorOf({"10.0.1", "7", "7"}), "");
  EXPECT_NE(errorOf({"a=ipc:///x", "b=ipc:///x"}), "") << "the same robot twice";
  std::vector<std::string> many{"10.0.1"};
  for (int i = 1; i <= 33; ++i) many.push_back(std::to_string(i));
  EXPECT_NE(errorOf(many).find("10.0.1.33: is one too many"), std::string::npos);
}

TEST(RobotList, FindsTheRobotsOfThisMachine) {
  const TestFolder folder;
  const std::string path = folder.file("");
  auto list = RobotList::parse({"auto"}, {"127.0.0.1", 15000, path.substr(0, path.size() - 1)});
  ASSERT_TRUE(list) << list.error().text();
  EXPECT_TRUE(list->searches());
  EXPECT_EQ(list->find(0), 0u);
  Network network;
  for (const char* name : {"red2.Tools", "red1.Tools", "red1.Motion", "blue1.Tools", ".Tools"})
    ASSERT_TRUE(network.listen(folder.endpoint(name)));
  std::ofstream{folder.file("file.Tools")} << "no socket";
  sockaddr_un left{AF_UNIX, {}};  // by a program that was killed
  std::strcpy(left.sun_path, folder.file("red4.Tools").c_str());
  const FileDescriptor dead{socket(AF_UNIX, SOCK_SEQPACKET, 0)};
  ASSERT_EQ(bind(dead.number(), reinterpret_cast<sockaddr*>(&left), sizeof left), 0);
  EXPECT_EQ(list->find(500), 0u) << "it looks once a second";
  ASSERT_EQ(list->find(1000), 3u);
  ASSERT_TRUE(network.listen(folder.endpoint("red3.Tools")));
  ASSERT_EQ(list->find(2000), 1u);
  std::string found;
  for (const RoutedRobot& r : list->robots())
    found += r.name + " " + r.team + " " + r.tools.substr(r.tools.rfind(':')) + "\n";
  EXPECT_EQ(found, "blue1 blue :15301\nred1 red :15302\nred2 red :15303\nred3 red :15304\n");
  EXPECT_EQ(list->robots()[1].robot, folder.endpoint("red1.Tools"));
}

TEST(RobotList, FindsTheRobotsOfASubnet) {
  Network network;
  const std::string first = (*network.listen("tcp://127.0.0.11:*"))->endpoint();
  const int port = std::stoi(first.substr(first.rfind(':') + 1));
  const std::string end = ":" + std::to_string(port);
  ASSERT_TRUE(network.listen("tcp://127.0.0.12" + end));
  ASSERT_TRUE(network.listen("tcp://127.0.0.20" + end));
  auto list = RobotList::parse({"127.0.0.20", "127.0.0", "auto"}, {"127.0.0.1", port, ""});
  ASSERT_TRUE(list) << list.error().text();
  ASSERT_TRUE(eventually([&] { return list->robots().size() >= 3; }, [&] { list->find(0); }));
  ASSERT_TRUE(network.listen("tcp://127.0.0.14" + end));
  for (int i = 0; i < 100; ++i) list->find(4999);
  EXPECT_EQ(list->robots().size(), 3u) << "one of them was named, and it looks every five seconds";
  ASSERT_TRUE(eventually([&] { return list->robots().size() == 4; }, [&] { list->find(5000); }));
  EXPECT_EQ(list->robots()[0].team, "A") << "by its place on the command line";
  const RoutedRobot& found = list->robots()[3];
  EXPECT_EQ(found.name, "127.0.0.14");
  EXPECT_EQ(found.robot, "tcp://127.0.0.14" + end);
  EXPECT_EQ(found.tools, "tcp://127.0.0.1:" + std::to_string(port + 14));
  EXPECT_EQ(found.team, "127.0.0.1") << "10 to 19 are a team";
}

TEST(RouterSettings, AreKeptWhereAUsersStateBelongs) {
  const TestFolder folder;
  ASSERT_EQ(setenv("XDG_STATE_HOME", folder.file("state").c_str(), 1), 0);
  EXPECT_EQ(lastSettingsFile(), folder.file("state/gt2003/router.cfg"));
  ASSERT_EQ(setenv("XDG_STATE_HOME", "relative", 1), 0);
  ASSERT_EQ(setenv("HOME", "/home/robot", 1), 0);
  EXPECT_EQ(lastSettingsFile(), "/home/robot/.local/state/gt2003/router.cfg");

  RouterSettings settings;
  settings.robots = {"10.0.1", "100", "red=ipc:///a b"};
  settings.port = 1234;
  settings.release = true;
  settings.join = {"tcp://10.0.1.1:15299"};
  settings.keys = "robot.key";
  const std::string file = folder.file("a/b/router.cfg");
  ASSERT_TRUE(keepSettings(settings, file));
  RouterSettings read;
  const auto done = readConfig(file, read);
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(read.robots, settings.robots);
  EXPECT_EQ(read.port, 1234);
  EXPECT_TRUE(read.release);
  EXPECT_EQ(read.join, settings.join);
  EXPECT_EQ(read.keys, std::filesystem::absolute("robot.key").string()) << "found from anywhere";
  EXPECT_EQ(read.connectKeys, "");
  std::ofstream{folder.file("file")} << "no folder";
  EXPECT_FALSE(keepSettings(settings, folder.file("file/router.cfg")));
}

TEST(RouterSettings, SayWhatARobotGets) {
  const RoutedRobot robot{"red1", "ipc:///red1", "tcp://127.0.0.1:15301", "A"};
  RouterSettings settings;
  EXPECT_EQ(settings.wanted(robot).team, "A");
  settings.team = "red";
  EXPECT_EQ(settings.wanted(robot).team, "red");
  EXPECT_EQ(settings.wanted(robot).tools, robot.tools);
  settings.noTeams = settings.release = true;
  EXPECT_EQ(settings.wanted(robot).team, "");
  EXPECT_EQ(settings.wanted(robot).tools, "") << "only team messages";
}

}  // namespace
}  // namespace gt
