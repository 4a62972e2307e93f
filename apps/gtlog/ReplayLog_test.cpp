#include "gtlog/ReplayLog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "match/Match.h"
#include "observer/ObservedRobot.h"
#include "observer/RobotLog.h"
#include "representations/behavior/BehaviorTrace.h"
#include "representations/modeling/RobotPose.h"
#include "robot/logs/LogRobot.h"
#include "streams/File.h"

namespace gt {
namespace {

using testing::HasSubstr;

/// Some seconds of a match, with logs as `make play` writes them, or with all images.
class ReplayLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    play("play", {});
    play("images", {.inputs = true});
    play("team", {.red = "kalman-study"});
    std::filesystem::create_directories(path("oracled/config"));
    ASSERT_TRUE(writeFile(path("oracled/config/modules.cfg"), "SelfLocator Oracled\n"));
    play("truth", {.red = path("oracled"), .truth = {"red"}});
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

  static std::string path(const std::string& name) { return (folder() / name).string(); }

 private:
  static void play(const std::string& name, MatchOptions options) {
    options.logs = path(name);
    std::filesystem::create_directories(options.logs);
    options.seed = 3;
    auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    while ((*match)->time().ms < 2500) (*match)->step();
    ASSERT_TRUE((*match)->close());
  }
  static std::filesystem::path folder() {
    return std::filesystem::path{testing::TempDir()} / "replay_log";
  }
};

void expectTheSame(const std::string& log, const std::string& copy) {
  const auto topics = replayLog({log}, copy);
  ASSERT_TRUE(topics) << topics.error().text();
  EXPECT_GE(topics->size(), 14u);
  for (const ReplayedTopic& topic : *topics) {
    EXPECT_GT(topic.recorded, 50u) << topic.topic;
    EXPECT_EQ(topic.recorded, topic.replayed) << log << topic.topic;
    EXPECT_EQ(topic.different, 0u) << log << topic.topic;
  }
}

TEST_F(ReplayLog, EveryLogOfAMatchComputesTheSameBitForBit) {
  for (const char* robot : {"red1", "red2", "red3", "red4", "blue1", "blue2", "blue3", "blue4"}) {
    const std::string log = path("play/" + std::string{robot} + ".mcap");
    expectTheSame(log, path("replayed.mcap"));
    // The whole robot, as it was, out of the log alone.
    const auto platform = ReplayPlatform::make({log});
    ASSERT_TRUE(platform) << platform.error().text();
    const Player& player = platform->robot().setup().player;
    EXPECT_EQ(std::string{enumName(player.teamColor)} + std::to_string(player.number()), robot);
  }
}

/// Its log holds the files that its robots read by their places in the team.
TEST_F(ReplayLog, ComputesTheSameOfATeamWithFilesOfItsOwn) {
  expectTheSame(path("team/red1.mcap"), path("replayed.mcap"));
  const auto log = McapReader::open(path("team/red1.mcap"));
  ASSERT_TRUE(log) << log.error().text();
  const auto setup = recordedSetup(*log, "red1.mcap");
  ASSERT_TRUE(setup) << setup.error().text();
  const auto own =
      std::ranges::find(setup->files, "config/modules/SelfLocator.Kalman.cfg", &SetupFile::name);
  ASSERT_NE(own, setup->files.end());
  EXPECT_EQ((std::string{own->content.begin(), own->content.end()}),
            *readFile("teams/kalman-study/config/modules/SelfLocator.Kalman.cfg"));
}

/// The truth that a robot was given is in its log; others may be given theirs in a replay.
TEST_F(ReplayLog, ComputesTheSameFromTheTruth) {
  expectTheSame(path("truth/red3.mcap"), path("replayed.mcap"));
  expectTheSame(path("replayed.mcap"), path("twice.mcap"));
  const auto given = replayLog(
      {path("play/red3.mcap"), {}, {}, {{"SelfLocator", "Oracled", "", 0}}}, path("other.mcap"));
  ASSERT_TRUE(given) << given.error().text();
  std::map<std::string, bool> differs;
  for (const ReplayedTopic& topic : *given) differs[topic.topic] = topic.different > 0;
  EXPECT_TRUE(differs.at("/RobotPose"));
  EXPECT_FALSE(differs.at("/OracledWorldState"));
}

TEST_F(ReplayLog, ComputesTheSameFromImagesAndFromReplays) {
  expectTheSame(path("images/blue3.mcap"), path("replayed.mcap"));
  expectTheSame(path("replayed.mcap"), path("twice.mcap"));
}

TEST_F(ReplayLog, SwitchesSolutions) {
  const auto differs = [&](const ReplayOptions& options, const std::string& name) {
    const auto topics = replayLog(options, path("other.mcap"));
    EXPECT_TRUE(topics) << topics.error().text();
    for (const ReplayedTopic& topic : *topics)
      if (topic.topic == name) return topic.different > 0;
    ADD_FAILURE() << name;
    return false;
  };
  ReplayOptions options{path("images/red1.mcap")};
  options.solutions = {{"ImageProcessor", "GridImageProcessor2", "", 0}};
  EXPECT_TRUE(differs(options, "/LandmarksPercept"));
  EXPECT_FALSE(differs(options, "/GameControlData"));
  // What is disabled comes from the log.
  options.solutions = {{"ImageProcessor", "disabled", "", 0}};
  EXPECT_FALSE(differs(options, "/LandmarksPercept"));
  EXPECT_FALSE(differs(options, "/RobotPose"));
  options.solutions = {{"ImageProcessor", "NoSuchSolution", "", 0}};
  EXPECT_THAT(replayLog(options, path("other.mcap")).error().text(), HasSubstr("NoSuchSolution"));
  options = {path("play/red1.mcap")};
  options.solutions = {{"ImageProcessor", "GT2003", "", 0}};
  EXPECT_THAT(replayLog(options, path("other.mcap")).error().text(),
              HasSubstr("does not hold the images' pixels"));
}

TEST_F(ReplayLog, RefusesWhatIsNoLogToReplay) {
  auto empty = McapWriter::open(path("empty.mcap"));
  empty->write("/Text", Time{8}, Text{"nothing sensed"});
  ASSERT_TRUE(empty->close());
  EXPECT_THAT(replayLog({path("empty.mcap")}, path("twice.mcap")).error().text(),
              HasSubstr("does not hold what its robot sensed"));
  EXPECT_THAT(replayLog({path("play/red1.mcap")}, path("play/red1.mcap")).error().text(),
              HasSubstr("is the log that is read"));
}

/// What a robot on a log believes, at the moment that was played last.
RobotPose poseOf(LogRobot& robot) {
  return *robot.robot().provided<RobotPose>();
}

TEST_F(ReplayLog, RobotsGoForwardAndBackOnALog) {
  auto opened = LogRobot::open(path("play/blue2.mcap"), {});
  ASSERT_TRUE(opened) << opened.error().text();
  LogRobot& robot = **opened;
  const auto ignore = [](const MessageQueue&) {};
  ASSERT_TRUE(robot.pass(2000, ignore));
  const Time at = robot.player().now();
  EXPECT_NEAR(static_cast<double>(at - robot.player().begin()), 2000, 40);
  const Pose2D pose = poseOf(robot).pose;
  const std::size_t position = robot.player().position();
  ASSERT_TRUE(robot.step(20, ignore));
  EXPECT_EQ(robot.player().position(), position + 20);
  ASSERT_TRUE(robot.step(-20, ignore));
  EXPECT_EQ(robot.player().now(), at);
  EXPECT_EQ(poseOf(robot).pose.translation, pose.translation)
      << "it has lived through the same again";
  EXPECT_EQ(robot.beginnings(), 1);
  ASSERT_TRUE(robot.goToTime(robot.player().begin() + 800, ignore));
  EXPECT_NEAR(static_cast<double>(robot.player().now() - robot.player().begin()), 800, 8);
  robot.player().setSpeed(2);
  ASSERT_TRUE(robot.pass(200, ignore));
  EXPECT_NEAR(static_cast<double>(robot.player().now() - robot.player().begin()), 1200, 16);
  robot.player().pause();
  ASSERT_TRUE(robot.pass(1000, ignore));
  EXPECT_NEAR(static_cast<double>(robot.player().now() - robot.player().begin()), 1200, 16);
  ASSERT_TRUE(robot.goToMessage(0, ignore));
  EXPECT_EQ(robot.player().now(), robot.player().begin());
}

/// What the log's robot decided is shown as recorded, or as the robot on the log decides now.
TEST_F(ReplayLog, RobotsOnALogShowWhatWasRecorded) {
  auto opened = LogRobot::open(path("play/red1.mcap"), {});
  ASSERT_TRUE(opened) << opened.error().text();
  ObservedRobot observed{"LOG1", (*opened)->link()};
  int traces = 0;
  const auto second = [&] {
    traces = 0;
    const auto done = (*opened)->pass(1000, [&](const MessageQueue& messages) {
      messages.handleAllMessages(
          [&](const Message& message) { traces += message.is<BehaviorTrace>(); });
      observed.take(messages);
    });
    EXPECT_TRUE(done) << done.error().text();
    return traces;
  };
  EXPECT_NEAR(second(), 25, 2) << "one for each image";
  ASSERT_NE(observed.newest<BehaviorTrace>(), nullptr);
  ASSERT_TRUE(observed.request(DebugRequest{traceKey, DebugKeyMode::always, 0}));
  EXPECT_NEAR(second(), 25, 2) << "not both";
}

TEST_F(ReplayLog, RobotsOnALogRefuseWhatItDoesNotHold) {
  auto opened = LogRobot::open(path("play/red1.mcap"), {});
  ASSERT_TRUE(opened) << opened.error().text();
  ObservedRobot observed{"LOG1", (*opened)->link()};
  const auto take = [&](const MessageQueue& messages) { observed.take(messages); };
  ASSERT_TRUE((*opened)->pass(1000, take));
  EXPECT_THAT(observed.request(SolutionRequest{"ImageProcessor", "GT2003"}).error().what,
              HasSubstr("does not hold the images' pixels"));
  EXPECT_TRUE(observed.request(SolutionRequest{"SelfLocator", "disabled"}));
  // Also when it begins anew.
  ASSERT_TRUE((*opened)->step(-10, take));
  EXPECT_EQ((*observed.task("SelfLocator"))->active, "disabled");
  EXPECT_EQ((*observed.task("ImageProcessor"))->active, "disabled");
  ASSERT_TRUE(observed.setup());
  EXPECT_EQ(observed.setup()->player.role, PlayerRole::goalie);
}

}  // namespace
}  // namespace gt
