#include "robot/Robot.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "logs/MessageTypes.h"
#include "logs/RobotLog.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

std::shared_ptr<const Configuration> configuration() {
  static const auto loaded = [] {
    auto result = loadConfiguration({});
    EXPECT_TRUE(result) << result.error().text();
    return *result;
  }();
  return loaded;
}

std::unique_ptr<Robot> makeRobot(const std::string& layout = "layouts/cmd.layout") {
  const auto loaded = loadLayout(layout);
  EXPECT_TRUE(loaded) << loaded.error().text();
  auto robot = Robot::make({configuration(), *loaded, {TeamColor::red, PlayerRole::striker1}, 1});
  EXPECT_TRUE(robot) << robot.error().text();
  return std::move(*robot);
}

/// Runs a robot without a simulator: it sees gray images, its joints follow the requests.
void runFor(Robot& robot, int ms, int from = 0) {
  Image image;
  image.allocate();
  SensorDataBuffer sensors;
  for (Time now{from + 8}; now.ms <= from + ms; now = now + 8) {
    SensorData frame = sensors.newest();
    frame.time = now;
    if (const JointData* joints = robot.provided<JointData>()) frame.joints = joints->angles;
    frame.acceleration = {0, 0, 9810};
    sensors.push(frame);
    robot.send(sensors);
    image.time = now;
    if (now.ms % 40 == 0) robot.send(image);
    robot.step(now);
  }
}

TEST(Robot, EveryLayoutOfTheRepositoryMakesOne) {
  int layouts = 0;
  for (const auto& entry : std::filesystem::directory_iterator{"layouts"}) {
    // For a robot on a log: LogPlatform_test makes one of it.
    // These two need a configuration of their own.
    const std::string name = entry.path().filename();
    if (name == "replay.layout" || name == "sensor-behavior.layout") continue;
    const auto robot = makeRobot(entry.path().string());
    ASSERT_TRUE(robot);
    runFor(*robot, 400);
    for (const Task& task :
         {*solutions().find("MotionControl"), *solutions().find("BehaviorControl")})
      for (const auto& process : robot->processes())
        for (const Stopwatch& watch : process->times())
          if (watch.name == task.name) {
            EXPECT_GT(watch.count, 5) << entry.path() << ' ' << task.name;
          }
    ++layouts;
  }
  EXPECT_GT(layouts, 0);
}

TEST(Robot, CognitionRunsByImageMotionByFrame) {
  const auto robot = makeRobot();
  runFor(*robot, 4000);
  for (const auto& process : robot->processes())
    EXPECT_EQ(process->times().front().count, process->name() == "Cognition" ? 100 : 500)
        << process->name();
}

TEST(Robot, RequestsConcernWhatTheyName) {
  const auto robot = makeRobot();
  EXPECT_TRUE(robot->request(SolutionRequest{"SelfLocator", "disabled"}));
  EXPECT_TRUE(robot->request(WatchRequest{"RobotPose", "Cognition"}));
  EXPECT_FALSE(robot->request(SolutionRequest{"SelfLocater", "MonteCarlo"}));
  EXPECT_FALSE(robot->request(WatchRequest{"RobotPose", "Nobody"}));
  EXPECT_FALSE(robot->request(DebugRequest{"no such key", DebugKeyMode::always}));
}

/// Takes all texts that the robot has reported.
std::string takeTexts(Robot& robot) {
  std::string texts;
  robot.toTools().handleAllMessages([&](const Message& message) {
    Text text;
    if (message.is<Text>() && message.read(text)) texts += text.text + "\n";
    RequestAnswer answer;
    if (message.is<RequestAnswer>() && message.read(answer) && !answer.what.empty())
      texts += answer.what + "\n";
    BehaviorState state;
    if (message.is<BehaviorState>() && message.read(state)) texts += toString(state);
  });
  robot.toTools().clear();
  return texts;
}

/// How often a robot sends a representation within a second.
int sentOf(Robot& robot, const RepresentationType& type, int from) {
  robot.toTools().clear();
  runFor(robot, 1000, from);
  int count = 0;
  robot.toTools().handleAllMessages([&](const Message& m) { count += m.id == type.id; });
  return count;
}

TEST(Robot, SendsRepresentationsAsOftenAsAskedFor) {
  const auto robot = makeRobot();
  runFor(*robot, 200);
  const auto& odometry = representation<OdometryData>();
  ASSERT_TRUE(robot->watch("OdometryData"));
  EXPECT_NEAR(sentOf(*robot, odometry, 200), 125, 1);
  ASSERT_TRUE(robot->watch("OdometryData", {DebugKeyMode::everyMs, 100}));
  EXPECT_NEAR(sentOf(*robot, odometry, 1200), 10, 1);
  ASSERT_TRUE(robot->watch("OdometryData", {DebugKeyMode::times, 3}));
  EXPECT_NEAR(sentOf(*robot, odometry, 2200), 13, 1) << "beside what is sent again and again";
  ASSERT_TRUE(robot->watch("OdometryData", {DebugKeyMode::disabled, 0}));
  EXPECT_EQ(sentOf(*robot, odometry, 3200), 0);
}

TEST(Robot, LivesOnWhatToolsAndTheOracleSayWhereItsTasksAreDisabled) {
  const auto robot = makeRobot();
  MotionRequest sit;
  sit.type = MotionType::specialAction;
  sit.specialAction = "pushStrong";
  RobotPose truth;
  truth.pose = {1, 200, 300};
  robot->fromTools().write({}, sit);
  runFor(*robot, 400);
  robot->layIfDisabled(truth);
  EXPECT_NE(robot->provided<MotionRequest>()->type, MotionType::specialAction);
  EXPECT_NE(robot->provided<RobotPose>()->pose.translation.x(), 200);
  for (const char* task : {"BehaviorControl", "SelfLocator"})
    ASSERT_TRUE(robot->request(SolutionRequest{task, "disabled"}));
  robot->fromTools().write({400}, sit);
  robot->layIfDisabled(truth);
  runFor(*robot, 400, 400);
  EXPECT_EQ(robot->provided<MotionRequest>()->type, MotionType::specialAction);
  EXPECT_EQ(robot->provided<MotionInfo>()->executed.specialAction, "pushStrong");
  EXPECT_EQ(robot->provided<RobotPose>()->pose.translation.x(), 200);
}

/// Has the ball one meter ahead.
class BallAhead {
 public:
  void update(const FrameInfo& frame, BallModel& ball) {
    ball.position = {1000, 0};
    ball.lastSeen = frame.time;
  }
};

Solution ballAhead(std::vector<Port> more = {}) {
  auto ports = ModuleAdapter<BallAhead>::ports();
  ports.insert(ports.end(), more.begin(), more.end());
  return {"Ahead", ports, [](ModuleContext context) {
            return std::make_unique<ModuleAdapter<BallAhead>>(std::move(context));
          }};
}

TEST(Robot, TakesSolutionsAtRunTime) {
  const auto robot = makeRobot();
  const auto other = makeRobot();
  for (Robot* each : {robot.get(), other.get()}) {
    ASSERT_TRUE(each->request(SolutionRequest{"BallLocator", "Probabilistic"}));
    runFor(*each, 400);
  }
  ASSERT_TRUE(robot->add("BallLocator", ballAhead()));
  EXPECT_FALSE(other->request(SolutionRequest{"BallLocator", "Ahead"})) << "of another robot";
  for (Robot* each : {robot.get(), other.get()}) runFor(*each, 400, 400);
  std::vector<std::byte> bytes, otherBytes;
  for (auto [each, to] : {std::pair{robot.get(), &bytes}, std::pair{other.get(), &otherBytes}}) {
    encode(*each->provided<RobotPose>(), *to);
    encode(*each->provided<JointData>(), *to);
  }
  EXPECT_EQ(bytes, otherBytes);
  for (const auto& process : robot->processes())
    if (process->solves("BallLocator")) {
      EXPECT_EQ(process->activeSolution("BallLocator"), "Probabilistic");
    }
  ASSERT_TRUE(robot->request(SolutionRequest{"BallLocator", "Ahead"}));
  ASSERT_TRUE(robot->add("BallLocator", ballAhead())) << "in place of itself";
  runFor(*robot, 400, 800);
  EXPECT_EQ(robot->provided<BallModel>()->position, (Vector2d{1000, 0}));
}

TEST(Robot, RefusesSolutionsThatItsLayoutCannotRun) {
  const auto robot = makeRobot("layouts/cmd.layout");
  const auto whatOf = [&](const char* task, Solution solution) {
    const auto done = robot->add(task, std::move(solution));
    return done ? std::string{} : done.error().what;
  };
  EXPECT_EQ(whatOf("BallFinder", ballAhead()), "no process of the robot solves this task");
  EXPECT_THAT(
      whatOf("BallLocator", ballAhead({{PortKind::input, &representation<MotionRequest>()}})),
      ::testing::StartsWith("a circle of tasks"));
  EXPECT_EQ(whatOf("BallLocator", ballAhead({{PortKind::input, &representation<ImageHeader>()}})),
            "nobody provides its ImageHeader");
  EXPECT_FALSE(robot->request(SolutionRequest{"BallLocator", "Ahead"}));
  runFor(*robot, 400);
  EXPECT_TRUE(robot->add("BallLocator", ballAhead()));
}

TEST(Robot, MovesHeadAndTailByHand) {
  const auto robot = makeRobot();
  ASSERT_TRUE(robot->request(SolutionRequest{"BehaviorControl", "disabled"}));
  robot->fromTools().write({}, HeadControlMode{HeadMode::none, Vector3d::Zero()});
  robot->fromTools().write({}, HeadMotionRequest{-0.4, 0.7, 0, 0});
  MotionRequest wag;
  wag.tail = TailRequest::wagHorizontalFast;
  robot->fromTools().write({}, wag);
  runFor(*robot, 2000);
  const JointAngles& angles = robot->provided<JointData>()->angles;
  EXPECT_NEAR(angles[Joint::headTilt], -0.4, 1e-9);
  EXPECT_NEAR(angles[Joint::headPan], 0.7, 1e-9);
  double least = 0, most = 0;
  for (int i = 0; i < 50; ++i) {
    runFor(*robot, 8, 2000 + 8 * i);
    const double pan = robot->provided<JointData>()->angles[Joint::tailPan];
    least = std::min(least, pan);
    most = std::max(most, pan);
  }
  EXPECT_LT(least, -0.3);
  EXPECT_GT(most, 0.3);
}

TEST(Robot, ExecutesWhatAPersonChoosesOfItsBehavior) {
  const auto robot = makeRobot();
  ASSERT_TRUE(robot->request(DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0}));
  BehaviorControlRequest control;
  control.root = "walk";
  control.basicBehavior = true;
  control.parameters = {"120", "0", "10"};
  control.outputs = {{"head_control_mode", "look_left"}};
  control.shown = {"head_control_mode"};
  robot->fromTools().write({}, control);
  runFor(*robot, 400);
  EXPECT_EQ(robot->provided<MotionRequest>()->walk.translation.x(), 120);
  EXPECT_EQ(robot->provided<HeadControlMode>()->mode, HeadMode::lookLeft);
  EXPECT_NE(takeTexts(*robot).find("walk("), std::string::npos);
  control.root = "no_such_option";
  robot->fromTools().write({400}, control);
  runFor(*robot, 120, 400);
  EXPECT_NE(takeTexts(*robot).find("the behavior has no no_such_option"), std::string::npos);
  robot->fromTools().write({520}, BehaviorControlRequest{});
  runFor(*robot, 120, 520);
  const std::string own = takeTexts(*robot);
  EXPECT_NE(own.find("play_soccer"), own.npos) << own;
}

TEST(Robot, PlaysOnWhileItsBehaviorIsEdited) {
  const auto robot = makeRobot();
  ASSERT_TRUE(robot->request(DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0}));
  runFor(*robot, 1000);
  const std::string before = takeTexts(*robot);
  EXPECT_NE(before.find("play_soccer() 960 ms: wait 960 ms"), before.npos) << before;

  const auto wrong =
      robot->request(BehaviorRequest{"edited.xabsl", {{"edited.xabsl", "option play {"}}});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().file, "edited.xabsl");
  const std::string flying =
      "namespace s(\"\") { behavior fly {} } agent a(\"\", play_soccer);"
      "option play_soccer { initial state wait { action { fly(); } } }";
  robot->fromTools().write({1000}, BehaviorRequest{"edited.xabsl", {{"edited.xabsl", flying}}});
  runFor(*robot, 1000, 1000);
  const std::string between = takeTexts(*robot);
  EXPECT_NE(between.find("edited.xabsl"), between.npos) << "the message is shown";
  EXPECT_NE(between.find("play_soccer() 1960 ms: wait 1960 ms"), between.npos) << between;

  std::string edited = flying;
  edited.replace(edited.find("fly"), 3, "getup");
  edited.replace(edited.find("fly"), 3, "getup");
  robot->fromTools().write({2000}, BehaviorRequest{"edited.xabsl", {{"edited.xabsl", edited}}});
  runFor(*robot, 1000, 2000);
  const std::string after = takeTexts(*robot);
  EXPECT_NE(after.find("play_soccer() 2960 ms: wait 2960 ms\n  getup()"), after.npos) << after;

  ASSERT_TRUE(robot->request(BehaviorRequest{"behavior/GT2003.xabsl", {}}));
  runFor(*robot, 1000, 3000);
  EXPECT_NE(takeTexts(*robot).find("play_soccer() 3960 ms: wait 3960 ms\n  show_role"), after.npos);
}

TEST(Robot, SameSeedSameRobot) {
  const auto run = [] {
    const auto robot = makeRobot();
    EXPECT_TRUE(robot->request(WatchRequest{"JointData", "Motion"}));
    EXPECT_TRUE(robot->request(WatchRequest{"RobotPose", "Cognition"}));
    GameControlData game;
    game.state = GameState::playing;
    robot->send(game);
    runFor(*robot, 2000);
    const auto bytes = robot->toTools().bytes();
    return std::vector<std::byte>{bytes.begin(), bytes.end()};
  };
  const auto first = run();
  EXPECT_GT(first.size(), 10000u);
  EXPECT_EQ(first, run());
}

// Else a message from a robot of another version would be passed on as one's own
// (network/Vocabulary.h).
TEST(RobotModules, KnowAllMessagesThatToolsAndPlatformsKnow) {
  const auto known = allModules().messageTypes();
  auto wanted = messageTypes();
  for (const auto& more : {platformRepresentations(), commandRepresentations()})
    wanted.insert(wanted.end(), more.begin(), more.end());
  std::vector<std::string> missing;
  for (const RepresentationType* type : wanted)
    if (std::ranges::find(known, type) == known.end()) missing.emplace_back(type->name);
  EXPECT_THAT(missing, ::testing::IsEmpty());
}

}  // namespace
}  // namespace gt
