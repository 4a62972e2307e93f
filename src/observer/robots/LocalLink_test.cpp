#include "observer/robots/LocalLink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observer/ObservedRobot.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/RobotPose.h"

namespace gt {
namespace {

using ::testing::Contains;

/// A robot of this program that is watched, and has seen one image.
class LocalLinkTest : public ::testing::Test {
 protected:
  LocalLinkTest() {
    const auto layout = loadLayout("layouts/cmd.layout");
    const auto configuration = loadConfiguration({});
    auto made = Robot::make({*configuration, *layout, {TeamColor::blue, PlayerRole::goalie}, 1});
    EXPECT_TRUE(made) << made.error().text();
    robot = std::move(*made);
    observed = std::make_unique<ObservedRobot>("blue1", std::make_unique<LocalLink>(*robot));
    step();
  }
  void step() {
    now = now + 40;
    Image image;
    image.allocate();
    image.time = now;
    robot->send(SensorDataBuffer{});
    robot->send(image);
    robot->step(now);
    observed->take(robot->toTools());
    robot->toTools().clear();
  }

  std::unique_ptr<Robot> robot;
  std::unique_ptr<ObservedRobot> observed;
  Time now;
};

TEST_F(LocalLinkTest, ValuesAreKnownWithoutACycle) {
  EXPECT_EQ((*observed->value<Player>())->teamColor, TeamColor::blue);
  EXPECT_EQ((*observed->value<Image>())->time, now) << "what the platform sends";
  EXPECT_EQ(*observed->get("RobotPose.validity"),
            std::to_string(robot->provided<RobotPose>()->validity).substr(0, 1));
  EXPECT_TRUE(observed->set("ImageProcessor.GT2003.denseSpacing", "4"));
  EXPECT_EQ(*observed->get("ImageProcessor.denseSpacing"), "4");
  EXPECT_FALSE(observed->set("ImageProcessor.denseSpacing", "400"));
  EXPECT_FALSE(observed->get("ImageProcessor.nonsense"));
  EXPECT_THAT(*observed->paths("RobotPose"), Contains("RobotPose.pose"));
  EXPECT_THAT(observed->inputs(), Contains("SensorDataBuffer"));
}

TEST_F(LocalLinkTest, ValuesAreReadWhereTheyLie) {
  int messages = 0;
  const auto passing = observed->passTo([&](const MessageQueue& queue) {
    queue.handleAllMessages([&](const Message&) { ++messages; });
  });
  EXPECT_EQ(*observed->value<Image>(), robot->value("Image")->data());
  EXPECT_EQ(*observed->value<RobotPose>(), robot->provided<RobotPose>());
  EXPECT_EQ(messages, 0);
  EXPECT_FALSE(observed->value("Nonsense"));
}

TEST_F(LocalLinkTest, RequestsAreCarriedOutAtOnce) {
  EXPECT_TRUE(observed->request(SolutionRequest{"SelfLocator", "disabled"}));
  EXPECT_EQ((*observed->task("SelfLocator"))->active, "disabled");
  EXPECT_TRUE(observed->set("RobotPose.pose.translation.x", "123"));
  EXPECT_EQ(*observed->get("RobotPose.pose.translation.x"), "123");
  EXPECT_EQ(observed->request(SolutionRequest{"Poet", "Rilke"}).error().what,
            "no process solves this task");
  ASSERT_TRUE(observed->times());
  EXPECT_EQ((*observed->times())->size(), 2u);
  const auto before = robot->processes().size();
  EXPECT_TRUE(
      observed->request(LayoutRequest{"single.layout", *readFile("layouts/single.layout")}));
  EXPECT_NE(robot->processes().size(), before);
  EXPECT_FALSE(observed->request(LayoutRequest{"nonsense", "process"}));
}

TEST_F(LocalLinkTest, OnlyWhatIsSubscribedComesWithTheCycles) {
  EXPECT_EQ(observed->newest<RobotPose>(), nullptr);
  {
    const auto subscription = observed->subscribe("RobotPose");
    step();
    EXPECT_NE(observed->newest<RobotPose>(), nullptr);
    EXPECT_EQ(observed->newest<Image>(), nullptr);
  }
  int messages = 0;
  const auto passing = observed->passTo([&](const MessageQueue& queue) {
    queue.handleAllMessages([&](const Message&) { ++messages; });
  });
  step();
  EXPECT_EQ(messages, 0);
  EXPECT_TRUE(observed->watch("RobotPose", {DebugKeyMode::everyMs, 80}));
  messages = 0;
  EXPECT_TRUE(observed->value("RobotPose")) << "does not end what was asked for by hand";
  for (int i = 0; i < 6; ++i) step();
  EXPECT_GE(messages, 3);
}

}  // namespace
}  // namespace gt
