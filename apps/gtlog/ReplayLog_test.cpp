#include "gtlog/ReplayLog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/File.h"
#include "logs/LogSelection.h"
#include "logs/LogTransfer.h"
#include "logs/RobotLog.h"
#include "match/Match.h"
#include "observer/ObservedRobot.h"
#include "observer/robots/LogRobot.h"
#include "representations/behavior/BehaviorTrace.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/OdometryData.h"
#include "support/FileSizeLimit.h"

namespace gt {
namespace {

using testing::HasSubstr;

/// Some seconds of a match, with logs as `make play` writes them, or with all images.
class ReplayLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    play("play");
    play("images", "", {}, true);
    play("team", "kalman-study");
    std::filesystem::create_directories(path("oracled/config"));
    ASSERT_TRUE(writeFile(path("oracled/config/modules.cfg"), "SelfLocator Oracled\n"));
    play("truth", path("oracled"), {"red"});
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

  static std::string path(const std::string& name) { return (folder() / name).string(); }

 private:
  static void play(const std::string& name, const std::string& red = "",
                   const std::vector<std::string>& truth = {}, bool inputs = false) {
    MatchOptions options;
    options.red = red;
    options.truth = truth;
    options.inputs = inputs;
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

void expectTheSame(const ReplayOptions& options, const std::string& copy) {
  const auto report = replayLog(options, copy);
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_GE(report->topics.size(), 13u);
  for (const ReplayedTopic& topic : report->topics) {
    EXPECT_GT(topic.recorded, 50u) << topic.topic;
    EXPECT_EQ(topic.recorded, topic.replayed) << options.log << topic.topic;
    EXPECT_EQ(topic.different, 0u) << options.log << topic.topic;
  }
  EXPECT_TRUE(report->within());
  EXPECT_THAT(report->caveats, testing::IsEmpty());
}

void expectTheSame(const std::string& log, const std::string& copy) {
  expectTheSame(ReplayOptions{log}, copy);
}

/// Whether a topic differs in a replay.
bool differs(const ReplayReport& report, const std::string& name) {
  const auto topic = std::ranges::find(report.topics, name, &ReplayedTopic::topic);
  EXPECT_NE(topic, report.topics.end()) << name;
  return topic != report.topics.end() && topic->different > 0;
}

std::uint64_t messagesOf(const std::string& log, const std::string& topic) {
  std::uint64_t count = 0;
  Selection selection;
  selection.topics = {topic};
  std::vector<Error> damage;
  const auto done = selection.forEach(
      log,
      [&](const auto&, const McapMessage&) {
        ++count;
        return Result<void>{};
      },
      damage);
  EXPECT_TRUE(done) << done.error().text();
  EXPECT_TRUE(damage.empty());
  return count;
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
  EXPECT_TRUE(differs(*given, "/RobotPose"));
  EXPECT_FALSE(differs(*given, "/OracledWorldState"));
}

TEST_F(ReplayLog, ComputesTheSameFromImagesAndFromReplays) {
  expectTheSame(path("images/blue3.mcap"), path("replayed.mcap"));
  expectTheSame(path("replayed.mcap"), path("twice.mcap"));
}

/// Twice the same command: no byte differs, nor is anything twice in the replay of a replay.
TEST_F(ReplayLog, WritesTheSameBytesWheneverItIsDone) {
  const std::string log = path("play/red2.mcap");
  expectTheSame(log, path("first.mcap"));
  expectTheSame(log, path("second.mcap"));
  EXPECT_TRUE(*readFile(path("first.mcap")) == *readFile(path("second.mcap")));
  expectTheSame(path("first.mcap"), path("twice.mcap"));
  for (const char* topic : {"/input/GameControlData", "/input/SensorData", "/GameControlData"}) {
    EXPECT_GT(messagesOf(log, topic), 50u);
    EXPECT_EQ(messagesOf(path("first.mcap"), topic), messagesOf(log, topic)) << topic;
    EXPECT_EQ(messagesOf(path("twice.mcap"), topic), messagesOf(log, topic)) << topic;
  }
}

/// What its modules remembered when it began is not in it: that is reported.
TEST_F(ReplayLog, ReportsThatALogBeginsInMidRun) {
  const std::string cut = path("cut.mcap");
  Selection selection;
  selection.from = 1.2;
  ASSERT_TRUE(cutLog(path("play/red2.mcap"), selection, cut));
  const auto report = replayLog({cut}, path("first.mcap"));
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(report->caveats, testing::ElementsAre(HasSubstr("begins in mid-run")));
  EXPECT_THAT(report->text(), testing::StartsWith("note: the log begins in mid-run"));
  ASSERT_TRUE(replayLog({cut}, path("second.mcap")));
  EXPECT_TRUE(*readFile(path("first.mcap")) == *readFile(path("second.mcap")));
}

/// The recorded body walked as the recorded solution had it walk: odometry and decisions are those.
TEST_F(ReplayLog, RunsAnotherSolutionOnWhatWasRecorded) {
  ReplayOptions options{path("play/red2.mcap")};
  options.solutions = {{"SelfLocator", "MonteCarlo", "", 0}};
  const auto other = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(other) << other.error().text();
  EXPECT_FALSE(other->within());
  EXPECT_TRUE(differs(*other, "/RobotPose"));
  for (const char* topic : {"/OdometryData", "/MotionRequest", "/HeadControlMode", "/CameraMatrix",
                            "/RobotState", "/Speaker", "/TeamMessage", "/LinesPercept"})
    EXPECT_FALSE(differs(*other, topic)) << topic;
  options.wholeRobot = true;
  const auto whole = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(whole) << whole.error().text();
  EXPECT_TRUE(differs(*whole, "/OdometryData"));
  EXPECT_TRUE(differs(*whole, "/MotionRequest"));
}

/// The configuration that the log's robot had, or one with another solution.
TEST_F(ReplayLog, RunsAnotherConfigurationOnWhatWasRecorded) {
  ReplayOptions options{path("play/red2.mcap")};
  options.layout = "layouts/cmd.layout";
  options.configuration = *loadConfiguration({});
  expectTheSame(options, path("replayed.mcap"));
  auto changed = std::make_shared<Configuration>(*options.configuration);
  std::erase_if(changed->solutions,
                [](const auto& choice) { return choice.task == "SelfLocator"; });
  changed->solutions.push_back({"SelfLocator", "MonteCarlo", "", 0});
  options.configuration = changed;
  const auto other = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(other) << other.error().text();
  EXPECT_TRUE(differs(*other, "/RobotPose"));
  for (const char* topic : {"/OdometryData", "/MotionRequest", "/HeadControlMode", "/CameraMatrix"})
    EXPECT_FALSE(differs(*other, topic)) << topic;
  options.wholeRobot = true;
  const auto whole = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(whole) << whole.error().text();
  EXPECT_TRUE(differs(*whole, "/OdometryData"));
  EXPECT_TRUE(differs(*whole, "/MotionRequest"));
}

/// The solution that the log's robot had, chosen again, computes all that it computed.
TEST_F(ReplayLog, ComputesTheSameWithTheSolutionThatWasRecorded) {
  for (const char* task :
       {"SelfLocator=Kalman", "BallLocator=PIDSmoothed", "PlayersLocator=Tracks"}) {
    ReplayOptions options{path("play/blue4.mcap")};
    const std::string choice = task;
    const auto at = choice.find('=');
    options.solutions = {{choice.substr(0, at), choice.substr(at + 1), "", 0}};
    expectTheSame(options, path("replayed.mcap"));
  }
}

TEST_F(ReplayLog, ReportsSolutionsThatMoveTheRobot) {
  ReplayOptions options{path("play/red2.mcap")};
  options.solutions = {{"MotionControl", "Debug", "", 0}};
  const auto report = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_THAT(report->caveats, testing::ElementsAre(HasSubstr("MotionControl moves the robot")));
}

TEST_F(ReplayLog, AllowsWhatMayDiffer) {
  ReplayOptions options{path("play/red2.mcap")};
  options.solutions = {{"BallLocator", "BallChallenge", "", 0}};
  const auto isWithin = [&](const std::vector<Tolerance>& tolerances) {
    const auto report = replayLog(options, path("other.mcap"), tolerances);
    EXPECT_TRUE(report) << report.error().text();
    return report && report->within();
  };
  const auto report = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(report) << report.error().text();
  std::vector<Tolerance> anything;
  double most = 0;
  for (const ReplayedTopic& topic : report->topics) {
    if (topic.same()) continue;
    anything.push_back({topic.topic.substr(1), HUGE_VAL});
    if (topic.topic == "/BallModel")
      for (const DifferentValue& value : topic.values) most = std::max(most, value.largest);
  }
  ASSERT_GT(most, 0);
  EXPECT_FALSE(isWithin({}));
  EXPECT_TRUE(isWithin(anything));
  auto ball = std::ranges::find(anything, "BallModel", &Tolerance::path);
  ASSERT_NE(ball, anything.end());
  ball->most = most;
  EXPECT_TRUE(isWithin(anything));
  ball->most = most / 2;
  EXPECT_FALSE(isWithin(anything));
}

TEST_F(ReplayLog, ReadsTolerances) {
  const auto read = parseTolerance("RobotPose.pose=2.5");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->path, "RobotPose.pose");
  EXPECT_EQ(read->most, 2.5);
  EXPECT_EQ(parseTolerance("RobotPose=inf")->most, HUGE_VAL);
  for (const char* wrong : {"RobotPose", "RobotPoze=1", "=1", "RobotPose=", "RobotPose=-1",
                            "RobotPose=nan", "RobotPose=1mm"})
    EXPECT_FALSE(parseTolerance(wrong)) << wrong;
}

TEST_F(ReplayLog, SwitchesSolutions) {
  const auto differs = [&](const ReplayOptions& chosen, const std::string& name) {
    const auto report = replayLog(chosen, path("other.mcap"));
    EXPECT_TRUE(report) << report.error().text();
    return report && gt::differs(*report, name);
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

TEST_F(ReplayLog, ReplacesAFileOnceItIsWhole) {
  const std::string copy = path("replaced.mcap");
  ASSERT_TRUE(writeFile(copy, "what was there"));
  {
    const FileSizeLimit limit{100'000};
    const auto full = replayLog({path("play/red1.mcap")}, copy);
    ASSERT_FALSE(full);
    EXPECT_THAT(full.error().text(), HasSubstr("cannot be written: File too large"));
  }
  EXPECT_EQ(*readFile(copy), "what was there");
  EXPECT_FALSE(std::filesystem::exists(copy + ".part"));
  expectTheSame(path("play/red1.mcap"), copy);
  EXPECT_FALSE(std::filesystem::exists(copy + ".part"));
}

TEST_F(ReplayLog, NamesTheLogThatCannotBeWritten) {
  const auto done = replayLog({path("play/red1.mcap")}, path("missing/new.mcap"));
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text(),
            path("missing/new.mcap") + ": cannot be written: No such file or directory");
}

/// A log of an earlier commit's robot, with these files.
void writeOlderLog(RecordedSetup setup, const std::string& path) {
  setup.commit = "c1d31b9";
  auto writer = RobotLog::open(path, {});
  ASSERT_TRUE(writer) << writer.error().text();
  attach(setup, writer->file());
  SensorDataBuffer sensors;
  for (int i = 1; i <= 100; ++i) {
    for (SensorData& frame : sensors.frames) frame.time = Time{8 * i};
    writer->writeInput(Time{8 * i}, sensors);
  }
  ASSERT_TRUE(writer->close());
}

/// Replaces a piece of a file in a log.
void change(RecordedSetup& setup, const std::string& name, const std::string& from,
            const std::string& to) {
  const auto file = std::ranges::find(setup.files, name, &SetupFile::name);
  ASSERT_NE(file, setup.files.end());
  std::string text{file->content.begin(), file->content.end()};
  const auto at = text.find(from);
  ASSERT_NE(at, text.npos);
  text.replace(at, from.size(), to);
  file->content = {text.begin(), text.end()};
}

/// A log of another version, whose files this program does not read: one line names the file in the
/// log, and with files of this program the log is replayed.
TEST_F(ReplayLog, ReplaysOlderLogsWithOtherFiles) {
  const std::string log = path("play/red1.mcap"), older = path("older.mcap");
  const auto recorded = recordedSetup(*McapReader::open(log), log);
  ASSERT_TRUE(recorded) << recorded.error().text();
  const auto errorOf = [&](const RecordedSetup& setup) {
    writeOlderLog(setup, older);
    const auto refused = replayLog({older}, path("other.mcap"));
    return refused ? "" : refused.error().text();
  };
  RecordedSetup setup = *recorded;
  std::erase_if(setup.files,
                [](const SetupFile& f) { return f.name.find("getup") != std::string::npos; });
  const std::string lacking = errorOf(setup);
  EXPECT_THAT(lacking, testing::StartsWith(older + ": motions: getup"));
  EXPECT_THAT(lacking, HasSubstr("commit c1d31b9"));
  // As in logs of 95922f2, whose behavior asks for a symbol that is gone: both places are in them.
  setup = *recorded;
  change(setup, "behavior/symbols/kick_symbols.xabsl", "float input kick.facing",
         "bool input kick.reaches;\n  float input kick.facing");
  change(setup, "behavior/options/ball/search_ball.xabsl", "ball.known.distance > search.known_far",
         "kick.reaches");
  const std::string asks = errorOf(setup);
  EXPECT_THAT(asks, testing::StartsWith(older + ": behavior/symbols/kick_symbols.xabsl:"));
  EXPECT_THAT(asks, HasSubstr("search_ball (behavior/options/ball/search_ball.xabsl:"));
  setup = *recorded;
  change(setup, "config/modules/WalkingEngine.InvKin.cfg", "", "footMode 1\n");
  const std::string refused = errorOf(setup);
  EXPECT_THAT(refused, testing::StartsWith(
                           older + ": config/modules/WalkingEngine.InvKin.cfg:1: footMode: "));
  EXPECT_THAT(refused, HasSubstr("commit c1d31b9"));
  EXPECT_THAT(refused, testing::Not(HasSubstr("\n")));
  ReplayOptions options{older};
  options.configuration = *loadConfiguration({});
  options.layout = "layouts/cmd.layout";
  const auto replayed = replayLog(options, path("other.mcap"));
  ASSERT_TRUE(replayed) << replayed.error().text();
  EXPECT_EQ(messagesOf(path("other.mcap"), "/OdometryData"), 100u);
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

/// A solution that is switched on while the log is played runs on what was recorded, too.
TEST_F(ReplayLog, RobotsOnALogRunAnotherSolutionOnWhatWasRecorded) {
  auto opened = LogRobot::open(path("play/red2.mcap"), {});
  ASSERT_TRUE(opened) << opened.error().text();
  ObservedRobot observed{"LOG1", (*opened)->link()};
  const auto take = [&](const MessageQueue& messages) { observed.take(messages); };
  ASSERT_TRUE(observed.request(SolutionRequest{"SelfLocator", "MonteCarlo"}));
  ASSERT_TRUE((*opened)->pass(2400, take));
  const auto last = [](LogRobot& robot) {
    return robot.robot().provided<OdometryData>()->pose.translation;
  };
  const auto recorded = LogRobot::open(path("play/red2.mcap"), {});
  ASSERT_TRUE((*recorded)->pass(2400, [](const MessageQueue&) {}));
  EXPECT_GT(last(**recorded).norm(), 50);
  EXPECT_EQ(last(**opened), last(**recorded));
  EXPECT_NE(poseOf(**opened).pose.translation, poseOf(**recorded).pose.translation);
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
