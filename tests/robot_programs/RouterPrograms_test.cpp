#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdlib>

#include "base/ChildProgram.h"
#include "framework/Requests.h"
#include "network/RobotList.h"
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
    words.insert(words.begin(), GT_PROGRAMS "/router");
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
        },
        10'000);
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

  const TestFolder folder;
  const int firstPort = freePort(), secondPort = freePort();
  Network network;
  std::vector<std::unique_ptr<ToolPort>> robots;
  std::array<std::array<bool, 4>, 4> heardOf{};
  std::int64_t round = 0;
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
  ChildProgram again{{GT_PROGRAMS "/router"}};
  EXPECT_TRUE(playAsATeam());
  first.kill();
  first.start();
  EXPECT_TRUE(playAsATeam());
}

}  // namespace
}  // namespace gt
