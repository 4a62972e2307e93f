#include "robot/Robot.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/SensorData.h"
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

/// Lets a robot live without a simulator: it sees grey pictures and its joints obey.
void live(Robot& robot, int ms, int from = 0) {
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
    if (entry.path().filename() == "replay.layout") continue;
    const auto robot = makeRobot(entry.path().string());
    ASSERT_TRUE(robot);
    live(*robot, 400);
    for (const Task& task :
         {*solutions().find("MotionControl"), *solutions().find("BehaviorControl")})
      for (const auto& process : robot->processes())
        for (const Stopwatch& watch : process->times())
          if (watch.name() == task.name) {
            EXPECT_GT(watch.count(), 5) << entry.path() << ' ' << task.name;
          }
    ++layouts;
  }
  EXPECT_GT(layouts, 0);
}

TEST(Robot, CognitionRunsByPictureMotionByFrame) {
  const auto robot = makeRobot();
  live(*robot, 4000);
  for (const auto& process : robot->processes())
    EXPECT_EQ(process->times().front().count(), process->name() == "Cognition" ? 100 : 500)
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

/// All texts that the robot has told, which are taken away.
std::string told(Robot& robot) {
  std::string texts;
  robot.toTools().handleAllMessages([&](const Message& message) {
    Text text;
    if (message.is<Text>() && message.read(text)) texts += text.text + "\n";
  });
  robot.toTools().clear();
  return texts;
}

TEST(Robot, PlaysOnWhileItsBehaviorIsEdited) {
  const auto robot = makeRobot();
  ASSERT_TRUE(robot->request(DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0}));
  live(*robot, 1000);
  const std::string before = told(*robot);
  EXPECT_NE(before.find("play_soccer() 960 ms: wait 960 ms"), before.npos) << before;

  const auto wrong = robot->request(BehaviorRequest{"edited.xabsl", "option play {"});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().file, "edited.xabsl");
  const std::string flying =
      "namespace s(\"\") { behavior fly {} } agent a(\"\", play_soccer);"
      "option play_soccer { initial state wait { action { fly(); } } }";
  robot->fromTools().write({1000}, BehaviorRequest{"edited.xabsl", flying});
  live(*robot, 1000, 1000);
  const std::string between = told(*robot);
  EXPECT_NE(between.find("edited.xabsl"), between.npos) << "the message is shown";
  EXPECT_NE(between.find("play_soccer() 1960 ms: wait 1960 ms"), between.npos) << between;

  std::string edited = flying;
  edited.replace(edited.find("fly"), 3, "getup");
  edited.replace(edited.find("fly"), 3, "getup");
  robot->fromTools().write({2000}, BehaviorRequest{"edited.xabsl", edited});
  live(*robot, 1000, 2000);
  const std::string after = told(*robot);
  EXPECT_NE(after.find("play_soccer() 2960 ms: wait 2960 ms\n  getup()"), after.npos) << after;

  ASSERT_TRUE(robot->request(BehaviorRequest{"behavior/GT2003.xabsl", {}}));
  live(*robot, 1000, 3000);
  EXPECT_NE(told(*robot).find("play_soccer() 3960 ms: wait 3960 ms\n  show_role"), after.npos);
}

TEST(Robot, SameSeedSameRobot) {
  const auto run = [] {
    const auto robot = makeRobot();
    EXPECT_TRUE(robot->request(WatchRequest{"JointData", "Motion"}));
    EXPECT_TRUE(robot->request(WatchRequest{"RobotPose", "Cognition"}));
    GameControlData game;
    game.state = GameState::playing;
    robot->send(game);
    live(*robot, 2000);
    const auto bytes = robot->toTools().bytes();
    return std::vector<std::byte>{bytes.begin(), bytes.end()};
  };
  const auto first = run();
  EXPECT_GT(first.size(), 10000u);
  EXPECT_EQ(first, run());
}

}  // namespace
}  // namespace gt
