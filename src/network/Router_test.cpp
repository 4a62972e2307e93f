#include "network/Router.h"

#include "framework/Requests.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::NumberPackage;
using testing::TestFolder;

/// Two robots of a team, the router and a tool.
class RouterTest : public ::testing::Test {
 protected:
  RouterTest() {
    RouterOptions options;
    for (const char* name : {"a", "b"}) {
      robots.push_back(*ToolPort::open(network, folder.endpoint(name)));
      options.robots.push_back({name, folder.endpoint(name), "tcp://127.0.0.1:0", "A"});
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

/// Four routers, each two of them joined; with the robots of the first team (two), the first (one),
/// the second (one), and none.
class JoinedRouters : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(makeKeys(folder.file("keys")));
    std::vector<std::string> opened;
    for (const std::string teams : {"AA", "A", "B", ""}) {
      RouterOptions options;
      options.listenKeys = *loadKeys(folder.file("keys/robot.key"));
      options.connectKeys = *loadKeys(folder.file("keys/tool.key"));
      for (const char team : teams) {
        const std::string name = "robot" + std::to_string(robots.size());
        robots.push_back(*ToolPort::open(network, folder.endpoint(name)));
        options.robots.push_back({name, folder.endpoint(name), "", {team}});
      }
      options.routers = "tcp://127.0.0.1:0";
      options.others = opened;
      auto router = Router::open(options);
      ASSERT_TRUE(router) << router.error().text();
      opened.push_back((*router)->endpointOfRouters());
      routers.push_back(std::move(*router));
    }
    toRobots.resize(robots.size());
  }
  void step() {
    for (std::size_t i = 0; i < robots.size(); ++i) robots[i]->update(toRobots[i]);
    for (const auto& router : routers) router->step(0);
  }
  /// Whether something comes true while all of them work.
  bool comesTrue(const std::function<bool()>& condition) {
    return eventually(condition, [this] { step(); });
  }
  /// When a player sent the newest of its messages that have reached a robot.
  Time heardOf(std::size_t robot, std::size_t player) {
    TeamMessages mates;
    toRobots[robot].handleAllMessages([&](const Message& m) {
      if (!m.is<TeamMessages>()) return;
      EXPECT_TRUE(m.read(mates));
    });
    return mates.byPlayer[player].message.timeSent;
  }

  const TestFolder folder{};
  Network network;
  std::vector<std::unique_ptr<ToolPort>> robots;
  std::vector<std::unique_ptr<Router>> routers;
  std::vector<MessageQueue> toRobots;
};

TEST_F(JoinedRouters, BringTeamMessagesToTheTeamMatesOfOthers) {
  ASSERT_TRUE(comesTrue([&] {
    return std::ranges::all_of(routers, [](const auto& r) { return r->routers() == 3; }) &&
           std::ranges::all_of(robots, [](const auto& r) { return r->tools() == 1; });
  }));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    TeamMessage message;
    message.playerNumber = static_cast<int>(i) + 1;
    message.timeSent = Time{100 + static_cast<std::int64_t>(i)};
    MessageQueue queue;
    queue.write(Time{100}, message);
    robots[i]->send(queue);
  }
  EXPECT_TRUE(comesTrue([&] {
    return heardOf(0, 1) == Time{101} && heardOf(0, 2) == Time{102} && heardOf(1, 0) == Time{100} &&
           heardOf(1, 2) == Time{102} && heardOf(2, 0) == Time{100} && heardOf(2, 1) == Time{101};
  }));
  for (int i = 0; i < 100; ++i) step();
  EXPECT_EQ(heardOf(0, 3), never()) << "of the other team";
  for (const std::size_t player : {0, 1, 2}) EXPECT_EQ(heardOf(3, player), never());
  EXPECT_EQ(heardOf(3, 3), never()) << "not its own";
}

TEST(Routers, LetInOnlyWhoHoldsTheKey) {
  const TestFolder folder;
  ASSERT_TRUE(makeKeys(folder.file("ours")));
  ASSERT_TRUE(makeKeys(folder.file("theirs")));
  RouterOptions options;
  options.routers = "tcp://127.0.0.1:0";
  options.listenKeys = *loadKeys(folder.file("ours/robot.key"));
  const auto router = *Router::open(options);
  RouterOptions joining;
  joining.others = {router->endpointOfRouters()};
  const auto without = *Router::open(joining);
  joining.connectKeys = *loadKeys(folder.file("theirs/tool.key"));
  const auto stranger = *Router::open(joining);
  joining.connectKeys = *loadKeys(folder.file("ours/tool.key"));
  const auto friendly = *Router::open(joining);
  const auto step = [&] {
    for (Router* each : {router.get(), without.get(), stranger.get(), friendly.get()})
      each->step(0);
  };
  ASSERT_TRUE(eventually([&] { return friendly->routers() == 1; }, step));
  for (int i = 0; i < 300; ++i) step();
  EXPECT_EQ(router->routers(), 1u);
  EXPECT_EQ(stranger->routers() + without->routers(), 0u);
  ASSERT_TRUE(
      eventually([&] { return router->refusals().at(0).second[Refusal::wrongKey] >= 2; }, step));
  EXPECT_EQ(router->refusals()[0].first, "other routers");
  EXPECT_EQ(router->takeNews(), std::vector<std::string>{"other routers: a tool is not let in: " +
                                                         std::string{describe(Refusal::wrongKey)}});
}

TEST(RouterOptions, OtherMachinesNeedKeys) {
  RouterOptions options;
  options.all = "tcp://0.0.0.0:0";
  EXPECT_FALSE(Router::open(options));
  options.all.clear();
  options.routers = "tcp://0.0.0.0:0";
  EXPECT_FALSE(Router::open(options));
}

}  // namespace
}  // namespace gt
