#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/ChildProgram.h"
#include "base/File.h"
#include "framework/Description.h"
#include "framework/Requests.h"
#include "network/RobotList.h"
#include "network/RouterSettings.h"
#include "representations/modeling/RobotPose.h"
#include "support/ProgramFolder.h"
#include "support/TestViewer.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::freePort;
using testing::TestFolder;

/// Two routers as programs, as on two machines, each with two robots of the red team that want to
/// see its key, as do the routers of each other.
class RouterProgramsTest : public ::testing::Test {
 protected:
  RouterProgramsTest() {
    EXPECT_TRUE(makeKeys(folder.file("keys")));
    EXPECT_EQ(setenv("XDG_STATE_HOME", folder.file("state").c_str(), 1), 0);
    for (const auto& [number, port] :
         {std::pair{11, firstPort}, {12, firstPort}, {21, secondPort}, {22, secondPort}}) {
      const std::string place = "tcp://127.0.0." + std::to_string(number) + ":";
      robots.push_back(*ToolPort::open(network, place + std::to_string(port),
                                       *loadKeys(folder.file("keys/robot.key"))));
    }
  }
  std::vector<std::string> command(std::vector<std::string> words, int port) const {
    words.insert(words.begin(), programFolder() + "/router");
    words.insert(words.end(),
                 {"--port", std::to_string(port), "--team", "red", "--keys",
                  folder.file("keys/robot.key"), "--connect-keys", folder.file("keys/tool.key")});
    return words;
  }
  /// Each robot sends its teammates something until each has heard of the three others.
  bool playAsATeam() {
    ++round;
    for (auto& heard : heardOf) heard.fill(false);
    return eventually(
        [&] {
          for (std::size_t i = 0; i < robots.size(); ++i)
            for (std::size_t mate = 0; mate < robots.size(); ++mate)
              if (i != mate && !heardOf[i][mate]) return false;
          return true;
        },
        [&] {
          network.wait(0);  // answers who may connect
          for (std::size_t i = 0; i < robots.size(); ++i) exchange(i);
        });
  }
  /// Lets tools come to a robot and go.
  void look(std::size_t robot) {
    network.wait(0);
    MessageQueue ignored;
    robots[robot]->update(ignored);
  }
  void exchange(std::size_t robot) {
    TeamMessage message;
    message.playerNumber = static_cast<int>(robot) + 1;
    message.timeSent = Time{round};
    MessageQueue queue;
    queue.write(Time{round}, message);
    robots[robot]->send(queue);
    MessageQueue fromRouter;
    robots[robot]->update(fromRouter);
    fromRouter.handleAllMessages([&](const Message& m) {
      TeamMessages mates;
      if (!m.is<TeamMessages>() || !m.read(mates)) return;
      for (std::size_t mate = 0; mate < 4; ++mate)
        if (mates.byPlayer[mate].message.timeSent == Time{round}) heardOf[robot][mate] = true;
    });
  }

  /// Sends what tools ask a robot for that knows where it is.
  void answer(std::size_t robot) {
    MessageQueue requests, answers;
    network.wait(0);
    robots[robot]->update(requests);
    requests.handleAllMessages([&](const Message& request) {
      ProcessDescription description;
      description.process = "Cognition";
      description.representations = {{"RobotPose", RepresentationOrigin::provided, true, 0}};
      if (request.is<DescriptionRequest>()) answers.write(Time{}, description);
      WatchRequest watch;
      if (request.is<WatchRequest>() && request.read(watch))
        watched = watch.representation == "RobotPose" && watch.mode == DebugKeyMode::always;
      answers.write(Time{}, answerTo(request, "Cognition", {}));
    });
    if (watched) answers.write(Time{++round}, RobotPose{{0, {100, 200}}, 1});
    robots[robot]->send(answers);
  }

  const TestFolder folder;
  const int firstPort = freePort(), secondPort = freePort();
  Network network;
  std::vector<std::unique_ptr<ToolPort>> robots;
  std::array<std::array<bool, 4>, 4> heardOf{};
  std::int64_t round = 0;
  bool watched = false;
};

TEST_F(RouterProgramsTest, TheRobotsOfTwoRoutersPlayAsATeam) {
  // One finds its robots, the other is given them.
  ChildProgram first{command({"127.0.0", "auto", "--routers"}, firstPort)};
  ASSERT_TRUE(eventually([&] { return robots[0]->tools() > 0; }, [&] { look(0); }));
  const std::string routers = "tcp://127.0.0.1:" + std::to_string(firstPort + 299);
  ChildProgram second{command({"127.0.0", "21", "22", "--join", routers}, secondPort)};
  ASSERT_TRUE(playAsATeam());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FALSE(heardOf[i][i]) << "itself";

  // Started without arguments it does what it did the last time.
  second.kill(SIGTERM);
  EXPECT_TRUE(WIFEXITED(second.status()) && WEXITSTATUS(second.status()) == 0);
  ASSERT_TRUE(eventually([&] { return robots[2]->tools() == 0; }, [&] { look(2); }));
  ChildProgram again{{programFolder() + "/router"}};
  EXPECT_TRUE(playAsATeam());
  first.kill();
  first.start();
  EXPECT_TRUE(playAsATeam());
}

/// Strangers that come again and again neither hold up the team nor keep out a tool that has the
/// key, and the router's statistics say who was not let in.
TEST_F(RouterProgramsTest, AFloodOfWrongKeysKeepsNoToolOut) {
  ASSERT_TRUE(makeKeys(folder.file("theirs")));
  const std::string statistics = folder.file("statistics");
  std::vector<std::string> logged{"/bin/sh", "-c", "exec \"$0\" \"$@\" >" + statistics};
  const auto words = command({"127.0.0", "11", "12", "--routers"}, firstPort);
  logged.insert(logged.end(), words.begin(), words.end());
  ChildProgram first{logged}, second{command({"127.0.0", "21", "22", "--join",
                                              "tcp://127.0.0.1:" + std::to_string(firstPort + 299)},
                                             secondPort)};
  ASSERT_TRUE(playAsATeam());

  Network strangers, friends;
  std::vector<std::unique_ptr<ToolConnection>> flood;
  const Keys theirs = *loadKeys(folder.file("theirs/tool.key"));
  const auto endpoint = [&](int number) {
    return "tcp://127.0.0.1:" + std::to_string(firstPort + number);
  };
  for (int i = 0; i < 200; ++i)
    flood.push_back(*ToolConnection::open(strangers, endpoint(i % 3 == 0 ? routersPort : 11),
                                          i % 2 == 0 ? std::optional{theirs} : std::nullopt));
  const auto tool =
      *ToolConnection::open(friends, endpoint(11), *loadKeys(folder.file("keys/tool.key")));
  MessageQueue ignored;
  const auto all = [&] {
    friends.wait(0);
    tool->update(ignored);
    answer(0);
  };
  EXPECT_TRUE(eventually([&] { return tool->connected(); }, all));
  EXPECT_TRUE(playAsATeam());
  // Each is refused, again and again.
  const auto isRefused = [](const auto& stranger) { return !stranger->trouble().empty(); };
  EXPECT_TRUE(eventually([&] { return std::ranges::all_of(flood, isRefused); }, all));
  EXPECT_TRUE(tool->connected());
  EXPECT_TRUE(playAsATeam());
  EXPECT_TRUE(first.runs());
  first.kill(SIGTERM);
  EXPECT_TRUE(WIFEXITED(first.status()) && WEXITSTATUS(first.status()) == 0);
  const std::string report = *readFile(statistics);
  for (const char* port : {"127.0.0.11: ", "other routers: "}) {
    const std::size_t line = report.rfind(port);
    ASSERT_NE(line, report.npos) << report;
    EXPECT_NE(report.substr(line, report.find('\n', line) - line).find(describe(Refusal::wrongKey)),
              report.npos)
        << report;
  }
}

TEST_F(RouterProgramsTest, ViewersSeeRobotsElsewhere) {
  const int port = freePort();
  ChildProgram router{command({"127.0.0", "11", "--foxglove", std::to_string(port),
                               "--foxglove-origin", "https://viewer.example"},
                              firstPort)};
  std::optional<testing::TestViewer> viewer;
  const auto work = [&] {
    answer(0);
    if (!viewer) viewer = testing::TestViewer::connect(static_cast<std::uint16_t>(port));
    if (viewer) viewer->read();
  };
  const std::string topic = "/127.0.0.11/RobotPose";
  ASSERT_TRUE(eventually([&] { return viewer && viewer->channels.contains(topic); }, work));
  EXPECT_FALSE(watched) << "nobody has subscribed";
  viewer->subscribe(5, topic);
  ASSERT_TRUE(eventually([&] { return !viewer->data.empty(); }, work));
  RobotPose pose;
  ASSERT_TRUE(decode(std::as_bytes(std::span{viewer->data.front().bytes}), pose));
  EXPECT_EQ(pose.pose.translation, Vector2d(100, 200));
  const auto answerTo = [&](const std::string& origin) {
    return testing::TestViewer::answerTo(static_cast<std::uint16_t>(port), origin);
  };
  EXPECT_EQ(answerTo("https://viewer.example"), 101u);
  EXPECT_EQ(answerTo("https://elsewhere.example"), 403u);
}

}  // namespace
}  // namespace gt
