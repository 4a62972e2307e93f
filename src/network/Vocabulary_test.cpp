#include "network/Vocabulary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "network/Router.h"
#include "network/ToolPort.h"
#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;
using testing::NumberPackage;
using testing::TestFolder;
namespace newer = testing::newer;

struct Name {
  std::string name;

  static constexpr auto fields() { return Fields{field<&Name::name>()}; }
};

const Vocabulary& robots() {
  static const Vocabulary known{{&representation<NumberPackage>(), &representation<Name>()}};
  return known;
}
const Vocabulary& tools() {
  static const Vocabulary known{{&representation<Name>(), &representation<newer::NumberPackage>()}};
  return known;
}

template <typename T>
std::vector<T> all(const MessageQueue& queue) {
  std::vector<T> values;
  queue.handleAllMessages([&](const Message& message) {
    T value;
    if (message.is<T>() && message.read(value)) values.push_back(value);
  });
  return values;
}

TEST(Vocabulary, IsThatOfItsTypesWhateverTheirOrder) {
  const Vocabulary same{{&representation<Name>(), &representation<NumberPackage>(),
                         &representation<Name>(), &representation<MessageQueue>()}};
  EXPECT_EQ(robots().id(), same.id());
  EXPECT_NE(robots().id(), tools().id());
  EXPECT_NE(Vocabulary{{}}.id(), 0u);
  EXPECT_EQ(robots().find(messageId<Name>()), &representation<Name>());
  EXPECT_EQ(robots().find(1), nullptr);
}

/// Who describes a type again and again neither takes time for it nor fills the memory.
TEST(Interpreter, TakesOneDescriptionOfATypeAndLimitsWhatItReports) {
  Interpreter interpreter{&tools()};
  TypeDescriptions many{7, {}};
  for (int i = 0; i < 10'000; ++i)
    many.types.push_back({messageId<NumberPackage>(), "a/msg/B", "no schema at all"});
  interpreter.learn(many);
  EXPECT_EQ(interpreter.takeNews().size(), 1u);
  many.types.resize(1);
  for (int i = 0; i < 1000; ++i) interpreter.learn(many);
  EXPECT_EQ(interpreter.takeNews().size(), 100u);
}

TEST(Interpreter, RefusesWhatItCannotRead) {
  Interpreter interpreter{&tools()};
  EXPECT_TRUE(interpreter.knows(0));
  EXPECT_FALSE(interpreter.knows(7));
  interpreter.learn({7, {{messageId<NumberPackage>(), "a/msg/B", "no schema at all"}}});
  EXPECT_TRUE(interpreter.knows(7));
  EXPECT_THAT(interpreter.takeNews(),
              ::testing::ElementsAre(::testing::HasSubstr("its NumberPackage cannot be read: ")));
  MessageQueue queue, taken;
  queue.write(Time{1}, NumberPackage{5});
  queue.write(Time{2}, Name{"ball"});
  interpreter.take(queue, taken);
  EXPECT_TRUE(all<newer::NumberPackage>(taken).empty());
  EXPECT_EQ(all<Name>(taken).at(0).name, "ball");
}

/// A robot and a tool of different versions, with or without a router between them.
class Versions : public ::testing::TestWithParam<bool> {
 protected:
  Versions() {
    port = *ToolPort::open(robotNetwork, folder.endpoint("robot"), {}, &robots());
    std::string endpoint = folder.endpoint("robot");
    if (GetParam()) {
      RouterOptions options;
      options.robots = {{"robot", endpoint, folder.endpoint("router"), ""}};
      router = *Router::open(options);
      endpoint = folder.endpoint("router");
    }
    tool = *ToolConnection::open(toolNetwork, endpoint, {}, &tools());
  }
  void step() {
    port->update(toRobot);
    if (router) router->step(0);
    tool->update(toTool);
  }

  const TestFolder folder;
  Network robotNetwork, toolNetwork;
  std::unique_ptr<ToolPort> port;
  std::unique_ptr<Router> router;
  std::unique_ptr<ToolConnection> tool;
  MessageQueue toRobot, toTool;
};

TEST_P(Versions, AToolReadsMessagesOfAnotherVersionFieldByField) {
  int number = 0;
  ASSERT_TRUE(eventually([&] { return all<newer::NumberPackage>(toTool).size() >= 10; },
                         [&] {
                           MessageQueue queue;
                           ++number;
                           queue.write(Time{number}, NumberPackage{number});
                           queue.write(Time{number}, Name{"ball"});
                           port->send(queue);
                           step();
                         }));
  const auto numbers = all<newer::NumberPackage>(toTool);
  EXPECT_GE(all<Name>(toTool).size(), 10u);
  EXPECT_EQ(numbers.back().number - numbers.front().number,
            static_cast<double>(numbers.size()) - 1);
  EXPECT_EQ(numbers.front().more, 0.5);
  EXPECT_THAT(tool->takeNews(),
              ::testing::ElementsAre("the program was built from another version: its "
                                     "NumberPackage is read field by field"));
}

using DirectlyOnly = Versions;

TEST_P(DirectlyOnly, ARobotReadsMessagesOfAnotherVersionFieldByField) {
  ASSERT_TRUE(eventually([&] { return !all<NumberPackage>(toRobot).empty(); },
                         [&] {
                           tool->out().write(Time{}, newer::NumberPackage{1, 42});
                           step();
                         }));
  EXPECT_EQ(all<NumberPackage>(toRobot).front().number, 42);
  EXPECT_THAT(port->takeNews(),
              ::testing::ElementsAre(::testing::HasSubstr("its NumberPackage is read field by")));
}

INSTANTIATE_TEST_SUITE_P(All, DirectlyOnly, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(All, Versions, ::testing::Bool(),
                         [](const auto& router) { return router.param ? "ByRouter" : "Directly"; });

}  // namespace
}  // namespace gt
