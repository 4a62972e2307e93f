#include "network/Router.h"

#include "framework/Requests.h"
#include "network/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::NumberPackage;
using testing::TestFolder;

TEST(Router, TakesRobotsAsTheReportsScriptDid) {
  const auto robots = parseRobots({"10.0.1.7", "10.0.2", "10", "11", "red1=ipc:///tmp/red1.Tools"},
                                  "127.0.0.1", 15000);
  ASSERT_TRUE(robots) << robots.error().text();
  ASSERT_EQ(robots->size(), 4u);
  EXPECT_EQ((*robots)[0].robot, "tcp://10.0.1.7:15000");
  EXPECT_EQ((*robots)[0].tools, "tcp://127.0.0.1:15007") << "15000 + least byte (report 5.3)";
  EXPECT_EQ((*robots)[2].name, "10.0.2.11");
  EXPECT_EQ((*robots)[3].robot, "ipc:///tmp/red1.Tools");
  const auto eight =
      parseRobots({"10.0.1", "1", "2", "3", "4", "5", "6", "7", "8"}, "127.0.0.1", 1);
  EXPECT_EQ((*eight)[3].team, 1u);
  EXPECT_EQ((*eight)[4].team, 2u);
  for (const char* wrong : {"", "red", "10.0.1.256", "1", "10.0.1.2.3", "=x", "10..1.2", "-1"})
    EXPECT_FALSE(parseRobots({wrong}, "127.0.0.1", 15000)) << wrong;
  EXPECT_FALSE(parseRobots({"10.0.1", "7", "7"}, "127.0.0.1", 15000));
}

/// Two robots of a team, the router and a tool.
class RouterTest : public ::testing::Test {
 protected:
  RouterTest() {
    RouterOptions options;
    for (const char* name : {"a", "b"}) {
      robots.push_back(*ToolPort::open(network, folder.endpoint(name)));
      options.robots.push_back({name, folder.endpoint(name), "tcp://127.0.0.1:0", 1});
    }
    options.all = "tcp://127.0.0.1:0";
    auto opened = Router::open(options);
    EXPECT_TRUE(opened) << opened.error().text();
    router = std::move(*opened);
  }
  void step() {
    for (std::size_t i = 0; i < 2; ++i) robots[i]->update(toRobot[i]);
    router->step(0);
  }
  template <typename T>
  static int count(const MessageQueue& queue) {
    int number = 0;
    queue.handleAllMessages([&](const Message& message) { number += message.is<T>(); });
    return number;
  }
  static MessageQueue one(int number) {
    MessageQueue queue;
    queue.write(Time{number}, NumberPackage{number});
    return queue;
  }

  TestFolder folder;
  Network network;
  std::vector<std::unique_ptr<ToolPort>> robots;
  MessageQueue toRobot[2];
  std::unique_ptr<Router> router;
};

TEST_F(RouterTest, PassesQueuesBetweenRobotsAndTheirTools) {
  auto toolOfA = *ToolConnection::open(network, router->endpointOf(0));
  auto toolOfB = *ToolConnection::open(network, router->endpointOf(1));
  auto toolOfAll = *ToolConnection::open(network, router->endpointOfAll());
  MessageQueue fromA, fromB, fromAll;
  const auto all = [&] {
    step();
    toolOfA->update(fromA);
    toolOfB->update(fromB);
    toolOfAll->update(fromAll);
  };
  ASSERT_TRUE(eventually(
      [&] {
        return robots[0]->tools() == 1 && robots[1]->tools() == 1 && toolOfAll->connected() &&
               router->statistics()[0].tools == 1 && router->statistics()[1].tools == 1;
      },
      all));
  robots[0]->send(one(1));
  robots[1]->send(one(2));
  EXPECT_TRUE(eventually([&] { return count<NumberPackage>(fromAll) == 2; }, all));
  EXPECT_EQ(count<NumberPackage>(fromA), 1);
  EXPECT_EQ(count<NumberPackage>(fromB), 1);
  toolOfB->out().write({}, NumberPackage{3});
  EXPECT_TRUE(eventually([&] { return count<NumberPackage>(toRobot[1]) == 1; }, all));
  EXPECT_EQ(count<NumberPackage>(toRobot[0]), 0);
  toolOfAll->out().write({}, NumberPackage{4});
  EXPECT_TRUE(eventually(
      [&] { return count<NumberPackage>(toRobot[0]) + count<NumberPackage>(toRobot[1]) == 3; },
      all));
  EXPECT_EQ(count<NumberPackage>(toRobot[0]), 1);
}

TEST_F(RouterTest, BringsTeamMessagesToTeamMates) {
  ASSERT_TRUE(eventually([&] { return count<WatchRequest>(toRobot[0]) > 0; }, [&] { step(); }))
      << "it asks for them";
  TeamMessage message;
  message.playerNumber = 3;
  message.timeSent = Time{100};
  MessageQueue queue;
  queue.write(Time{100}, message);
  robots[0]->send(queue);
  robots[1]->send(one(777));
  ASSERT_TRUE(eventually([&] { return count<TeamMessages>(toRobot[1]) > 0; }, [&] { step(); }));
  EXPECT_EQ(count<TeamMessages>(toRobot[0]), 0) << "not to who sent it";
  TeamMessages mates;
  toRobot[1].handleAllMessages([&](const Message& m) {
    if (!m.is<TeamMessages>()) return;
    EXPECT_TRUE(m.read(mates));
  });
  EXPECT_EQ(mates.byPlayer[2].message.timeSent, Time{100});
}

TEST(RouterOptions, OtherMachinesNeedKeys) {
  RouterOptions options;
  options.all = "tcp://0.0.0.0:0";
  EXPECT_FALSE(Router::open(options));
}

}  // namespace
}  // namespace gt
