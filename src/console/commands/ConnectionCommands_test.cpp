#include "console/TestSession.h"
#include "network/ToolPort.h"

namespace gt {
namespace {

using ConnectionCommands = SessionTest;

/// Report 5.2: to simulated robot, to all simulated robots, from simulated robot.
TEST_F(ConnectionCommands, SendsToMessageQueues) {
  const auto spacing = [&](const char* robot) {
    return *session->find(robot)->observed().get("ImageProcessor.GT2003.denseSpacing");
  };
  expectFine("robot red4");
  expectFine("to allSimulatedRobots set ImageProcessor.GT2003.denseSpacing 4");
  EXPECT_EQ(spacing("red1") + spacing("red4"), "44");
  expectFine("to simulatedRobot set ImageProcessor.GT2003.denseSpacing 3");
  EXPECT_EQ(spacing("red1") + spacing("red4"), "43") << "red4 is the connected one";
  EXPECT_EQ(console->selection(), std::vector<std::string>{"red4"});
  expectFine("robot all");
  expectFine("from simulatedRobot log start");
  EXPECT_TRUE(session->find("red1")->recorder.recording());
  EXPECT_FALSE(session->find("red4")->recorder.recording());
  EXPECT_THAT(console->selection(), testing::IsEmpty());
  expectError("to physicalRobot log stop", "physicalRobot", "there is no such robot");
  expectError("from allSimulatedRobots log stop", "from", "expected: from (physicalRobot");
  expectError("to nobody log stop", "to", "expected: to (physicalRobot");
  expectError("to simulatedRobot run 1", "run", "no command for selected robots");
  expectError("to simulatedRobot sr Poet Rilke", "Poet", "no process solves this task");
  EXPECT_THAT(console->selection(), testing::IsEmpty());
}

TEST_F(ConnectionCommands, ALineForOtherRobotsKeepsTheSelection) {
  expectFine("robot red4");
  ASSERT_TRUE(console->executeFor({"red1"}, "set ImageProcessor.denseSpacing 4"));
  EXPECT_THAT(console->selection(), ::testing::ElementsAre("red4"));
  EXPECT_EQ(value("red1.ImageProcessor.denseSpacing"), "4");
  EXPECT_EQ(value("red4.ImageProcessor.denseSpacing"), "2");
  EXPECT_FALSE(console->executeFor({"red1"}, "set ImageProcessor.nonsense 4"));
  EXPECT_FALSE(console->executeFor({"red9"}, "set ImageProcessor.denseSpacing 4"));
  EXPECT_THAT(console->selection(), ::testing::ElementsAre("red4"));
  ASSERT_TRUE(console->executeFor({}, "set ImageProcessor.denseSpacing 6"));
  EXPECT_EQ(value("red4.ImageProcessor.denseSpacing"), "6");
}

TEST_F(ConnectionCommands, TellWhyARobotIsNotReached) {
  ASSERT_TRUE(makeKeys(file("keys")));
  Network network;
  const auto dog = *ToolPort::open(network, "tcp://127.0.0.1:*", *loadKeys(file("keys/robot.key")));
  EXPECT_THAT(answers("sc dog=" + dog->endpoint()),
              testing::Contains("router: dog does not answer (it asks for a key, and this side has "
                                "none); it is connected as soon as it does"));
}

}  // namespace
}  // namespace gt
