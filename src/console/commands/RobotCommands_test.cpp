#include <algorithm>
#include <filesystem>

#include "base/File.h"
#include "console/TestSession.h"
#include "logs/LogTransfer.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/RobotPose.h"

namespace gt {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

class RobotCommands : public SessionTest {
 protected:
  std::string solution(std::size_t i, std::string_view task) {
    for (const auto& process : robot(i).processes())
      if (process->solves(task)) return process->activeSolution(task);
    return "";
  }
};

TEST_F(RobotCommands, SwitchesSolutionsOfSelectedRobots) {
  expectFine("robot red4");
  expectFine("sr BallLocator disabled");
  EXPECT_EQ(solution(0, "BallLocator"), "PIDSmoothed");
  EXPECT_EQ(solution(1, "BallLocator"), "disabled");
  expectFine("robot all");
  expectFine("sr BallLocator disabled");
  EXPECT_EQ(solution(0, "BallLocator"), "disabled");
  expectFine("sr BallLocator PIDSmoothed");
  EXPECT_EQ(solution(1, "BallLocator"), "PIDSmoothed");
  expectError("sr BallLocator Nonsense", "BallLocator", "Nonsense");
  expectError("sr Nonsense disabled", "Nonsense", "no process solves");
  expectError("robot red7", "red7", "no robot");
  expectFine("sr ?");
  EXPECT_THAT(screen.printed, Contains("BallLocator PIDSmoothed"));
  screen.printed.clear();
  expectFine("sr SelfLocator ?");
  EXPECT_THAT(screen.printed, Contains("MonteCarlo"));
  EXPECT_THAT(screen.printed, Contains("Kalman (runs)"));
  EXPECT_THAT(screen.printed, Contains("disabled"));
}

TEST_F(RobotCommands, SetsDebugKeysAsTheReportDoes) {
  const DebugKey* key = DebugKey::find("ImageProcessor/percepts");
  ASSERT_NE(key, nullptr);
  const auto mode = [&] { return robot(0).processes()[0]->debug().keys().get(*key); };
  expectFine("dk ImageProcessor/percepts on");
  EXPECT_EQ(mode().mode, DebugKeyMode::always);
  expectFine("dk ImageProcessor/percepts 3");
  EXPECT_EQ(mode().mode, DebugKeyMode::times);
  expectFine("dk ImageProcessor/percepts every 5");
  EXPECT_EQ(mode().mode, DebugKeyMode::everyTimes);
  expectFine("dk ImageProcessor/percepts every 500 ms");
  EXPECT_EQ(mode().mode, DebugKeyMode::everyMs);
  EXPECT_EQ(mode().n, 500);
  expectFine("dk ImageProcessor/percepts off");
  EXPECT_EQ(mode().mode, DebugKeyMode::disabled);
  expectError("dk Nonsense on", "Nonsense", "no such debug key");
  expectError("dk ImageProcessor/percepts often", "often", "is no number");
  expectError("dk ImageProcessor/percepts every -3", "dk", "expected");
  expectFine("dk ?");
  EXPECT_THAT(screen.printed, Contains("ImageProcessor/percepts"));
}

TEST_F(RobotCommands, AcceptsTheReportsDebugKeys) {
  const auto mode = [&](const char* key) {
    return robot(0).processes()[0]->debug().keys().get(*DebugKey::find(key)).mode;
  };
  expectFine("dk send_imageProcessor_horizon_drawing every 100 ms");
  EXPECT_EQ(mode("ImageProcessor/horizon"), DebugKeyMode::everyMs);
  expectFine("dk send_selfLocatorField_drawing on");
  EXPECT_EQ(mode("SelfLocator/samples"), DebugKeyMode::always);
  expectFine("dk sendXabsl2DebugMessages on");
  expectFine("dk sendJPEGImage on");
  expectFine("dk sendRobotPose on");
  expectError("dk sendNothing on", "Nothing", "no process");
  expectFine("log start");
  expectFine("run 1");
  const auto* behavior = session->robots()[0]->observed().newest<BehaviorState>();
  ASSERT_TRUE(behavior);
  EXPECT_FALSE(behavior->activations.empty());
  expectFine("robot red1");
  expectFine("log save " + file("seen"));
  EXPECT_GT(std::filesystem::file_size(file("seen.mcap")), 10'000u);
  // What was recorded can be replayed into the modules again.
  expectFine("robot all");
  expectFine("sl LOG1 " + file("seen.mcap"));
  expectFine("robot LOG1");
  expectFine("sr SensorDataProcessor disabled");
  expectFine("sr ImageProcessor GT2003");
  expectFine("run 1");
  const auto picture = session->find("LOG1")->observed().value<Image>();
  ASSERT_TRUE(picture) << picture.error().text();
  EXPECT_EQ((*picture)->info.width, 176);
  expectError("sl LOG1 " + file("seen.mcap"), "LOG1", "already");
  EXPECT_FALSE(console->execute("sl LOG2 " + file("nothing")));
}

/// Two logs of one match, the second of which begins later: they run in step.
TEST_F(RobotCommands, PlaysSeveralLogsInStep) {
  expectFine("log start");
  expectFine("run 1");
  expectFine("robot red1");
  expectFine("log save " + file("whole"));
  expectFine("log stop");
  Selection late;
  late.from = 0.6;
  ASSERT_TRUE(cutLog(file("whole.mcap"), late, file("late.mcap")));
  // The later one first, too.
  expectFine("sl LATE " + file("late.mcap"));
  expectFine("sl WHOLE " + file("whole.mcap"));
  const LogPlayer& whole = session->find("WHOLE")->onLog()->player();
  const LogPlayer& waiting = session->find("LATE")->onLog()->player();
  const std::int64_t wait = waiting.begin() - whole.begin();
  ASSERT_GT(wait, 400);
  expectFine("run 0.4");
  EXPECT_EQ(waiting.position(), 0u);
  expectFine("run 0.4");
  EXPECT_NEAR(static_cast<double>(waiting.now() - whole.now()), 0, 16);
  EXPECT_NEAR(static_cast<double>(waiting.time() - whole.time()), 0, 16);
  // Also from a time on at which the later one does not run yet.
  expectFine("robot WHOLE LATE");
  expectFine("lp time 0.2");
  EXPECT_NEAR(static_cast<double>(waiting.time() - whole.time()), 0, 16);
  expectFine("run 0.6");
  EXPECT_NEAR(static_cast<double>(waiting.now() - whole.now()), 0, 16);
}

/// What another program makes of a log while a robot runs on it.
TEST_F(RobotCommands, NoticesThatALogIsDamagedOrChanged) {
  expectFine("log start");
  expectFine("run 1");
  expectFine("robot red1");
  expectFine("log save " + file("whole"));
  expectFine("log stop");
  const std::string bytes = *readFile(file("whole.mcap"));
  ASSERT_TRUE(writeFile(file("cut.mcap"), std::string_view{bytes}.substr(0, bytes.size() - 100)));
  expectFine("sl CUT " + file("cut.mcap"));
  EXPECT_THAT(screen.printed,
              Contains(AllOf(HasSubstr(file("cut.mcap") + ": after "),
                             HasSubstr(" s: the index is cut off; the messages are whole"))));
  expectFine("sl WHOLE " + file("whole.mcap"));
  std::filesystem::resize_file(file("whole.mcap"), bytes.size() / 2);
  screen.printed.clear();
  expectFine("run 1");
  const auto told = HasSubstr("the log was changed by another program");
  EXPECT_THAT(screen.printed, Contains(told));
  EXPECT_EQ(std::ranges::count_if(
                screen.printed,
                [](const std::string& line) { return line.find("changed by") != line.npos; }),
            1);
  EXPECT_TRUE(session->find("WHOLE")->onLog()->player().atEnd());
}

TEST_F(RobotCommands, FillsTheQueueToTheToolsAsAskedFor) {
  for (const char* mode : {"queue", "replace", "reject", "collect 5", "save 2.5"})
    expectFine(std::string{"qfr "} + mode);
  expectFine("dk sendOdometryData on");
  expectFine("log start");
  const auto messagesAfter = [&](const std::string& line, const std::string& seconds) {
    expectFine(line);
    expectFine("log clear");
    expectFine("run " + seconds);
    return session->robots()[0]->recorder.messages();
  };
  expectFine("robot red1");
  EXPECT_EQ(messagesAfter("qfr reject", "0.2"), 0u);
  const auto all = messagesAfter("qfr queue", "0.2");
  EXPECT_GE(all, 50u) << "sensor data and odometry of 25 frames";
  const auto half = messagesAfter("qfr collect 0.1", "0.2");
  EXPECT_GT(half, all / 3);
  EXPECT_LT(half, all * 2 / 3);
  EXPECT_GT(messagesAfter("qfr replace", "0.2"), 0u);
  expectError("qfr sometimes", "qfr", "expected: qfr queue");
  expectError("qfr collect", "qfr", "expected");
  expectError("qfr collect -1", "qfr", "expected");
}

TEST_F(RobotCommands, SendsGenericDebugData) {
  expectFine("sg defaultObstaclesLocator 1 0 2000");
  expectFine("sg BallLocator 0.25");
  expectError("sg BallLocator one", "one", "is no number");
  expectError("sg numberOfFourierCoefficients 1", "numberOfFourierCoefficients", "no such id");
}

TEST_F(RobotCommands, ChangesLayouts) {
  ASSERT_EQ(robot(0).processes().size(), 2u);
  expectFine("layout layouts/single.layout");
  expectFine("run 0.1");
  EXPECT_EQ(robot(0).processes().size(), 1u);
  EXPECT_EQ(session->time(), Time{104});
  EXPECT_FALSE(console->execute("layout layouts/nonsense.layout"));
  expectError("run soon", "soon", "is no number");
}

/// The truth is given to the selected robots alone, when somebody asks for it.
TEST_F(RobotCommands, TakesWhatIsDisabledFromTheOracle) {
  expectFine("ci off");
  const char* refused = "'Oracled' reads OracledWorldState, which this robot does not get";
  expectError("sr SelfLocator Oracled", "sr", refused);
  expectFine("robot red4");
  expectFine("so on");
  expectFine("sr BallLocator Oracled");
  expectFine("robot red1");
  expectError("sr BallLocator Oracled", "sr", refused);
  expectFine("robot red4");
  expectFine("sr SelfLocator disabled");
  expectFine("run 1");
  EXPECT_EQ(session->match().summary().truth, std::vector<std::string>{"red4"});
  const auto error = [&] {
    return (robot(1).provided<RobotPose>()->pose.translation -
            session->simulation().world().robot(1).pose.translation)
        .norm();
  };
  EXPECT_LT(error(), 20);
  expectFine("so off");
  expectFine("place red4 1000 1000");
  expectFine("run 1");
  EXPECT_GT(error(), 500);
  expectFine("so on");
  expectFine("run 100 ms");
  EXPECT_LT(error(), 20);
}

}  // namespace
}  // namespace gt
