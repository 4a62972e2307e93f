#include "observer/MessageQueues.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "representations/behavior/MotionRequest.h"

namespace gt {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A robot that counts the motion requests that reach it, and may refuse them.
class Legs : public RobotLink {
 public:
  Legs(RobotKind kind, int& requests, bool willing)
      : kind_{kind}, requests_{requests}, willing_{willing} {}
  RobotKind kind() const override { return kind_; }
  MessageQueue& toRobot() override { return in_; }
  void exchange(const Taker& take) override {
    MessageQueue out;
    in_.handleAllMessages([&](const Message& message) {
      requests_ += message.is<MotionRequest>();
      if (!willing_) out.write({}, answerTo(message, "Motion", Error{.what = "is tired"}));
    });
    in_.clear();
    take(out);
  }

 private:
  RobotKind kind_;
  int& requests_;
  bool willing_;
  MessageQueue in_;
};

class MessageQueues : public ::testing::Test {
 protected:
  void add(const std::string& name, RobotKind kind, bool willing = true) {
    robots.push_back(std::make_unique<ObservedRobot>(
        name, std::make_unique<Legs>(kind, requests[name], willing)));
  }
  std::vector<ObservedRobot*> all() const {
    std::vector<ObservedRobot*> list;
    for (const auto& robot : robots) list.push_back(robot.get());
    return list;
  }
  std::vector<std::string> names(QueueName queue) const {
    std::vector<std::string> list;
    for (const ObservedRobot* robot : robotsOf(queue, all())) list.push_back(robot->name());
    return list;
  }

  std::map<std::string, int> requests;
  std::vector<std::unique_ptr<ObservedRobot>> robots;
};

TEST_F(MessageQueues, LeadToTheConnectedRobotOfAKindOrToAll) {
  add("red1", RobotKind::simulated);
  add("201", RobotKind::physical);
  add("red2", RobotKind::simulated);
  add("202", RobotKind::physical);
  using enum QueueName;
  EXPECT_THAT(names(toPhysicalRobot), ElementsAre("201"));
  EXPECT_THAT(names(toAllPhysicalRobots), ElementsAre("201", "202"));
  EXPECT_THAT(names(toSimulatedRobot), ElementsAre("red1"));
  EXPECT_THAT(names(toAllSimulatedRobots), ElementsAre("red1", "red2"));
  EXPECT_THAT(names(fromPhysicalRobot), ElementsAre("201"));
  EXPECT_THAT(names(fromSimulatedRobot), ElementsAre("red1"));
  EXPECT_THAT(names(toGUI), ElementsAre("201", "red1"));
}

TEST_F(MessageQueues, CarryMessages) {
  add("red1", RobotKind::simulated);
  add("201", RobotKind::physical, false);
  add("202", RobotKind::physical);
  EXPECT_TRUE(send(QueueName::toAllSimulatedRobots, all(), MotionRequest{}));
  EXPECT_EQ(requests["red1"], 1);
  EXPECT_EQ(requests["201"] + requests["202"], 0);
  EXPECT_EQ(send(QueueName::toAllPhysicalRobots, all(), MotionRequest{}).error().what, "is tired");
  EXPECT_EQ(requests["202"], 1) << "has it all the same";
  EXPECT_EQ(send(QueueName::fromPhysicalRobot, all(), MotionRequest{}).error().field,
            "fromPhysicalRobot");
  robots.clear();
  EXPECT_FALSE(send(QueueName::toPhysicalRobot, all(), MotionRequest{}));
}

}  // namespace
}  // namespace gt
