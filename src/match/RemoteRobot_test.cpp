#include "match/RemoteRobot.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/TestWire.h"

namespace gt {
namespace {

using testing::eventually;

/// A process of the robot elsewhere, which gives commands.
struct Motion {
  explicit Motion(const std::string& endpoint) {
    EXPECT_TRUE(wire.connect(platformProcess, endpoint));
    wire.provide(joints);
    wire.provide(odometry);
    wire.receive(platformProcess, sensors);
  }
  void send() {
    network.wait(0);
    wire.takeIn();
    sensors.receive();
    joints.send();
    odometry.send();
    joints.sendLater();
    odometry.sendLater();
    sensors.request();
    wire.askForMore();
  }

  Network network;
  Wire wire{network, "Motion"};
  JointData jointData;
  OdometryData odometryData;
  SensorDataBuffer sensorData;
  PackageSender joints{representation<JointData>(), &jointData};
  PackageSender odometry{representation<OdometryData>(), &odometryData};
  PackageReceiver sensors{representation<SensorDataBuffer>(), &sensorData};
};

class RemoteRobotTest : public ::testing::Test {
 protected:
  RemoteRobotTest() {
    plan_.processes.resize(1);
    plan_.processes[0].layout.name = "Motion";
    plan_.processes[0].order = {{&walk_, nullptr}};
    auto made = RemoteRobot::make({folder_.file("sockets"), "red1", {}}, plan_, {});
    EXPECT_TRUE(made) << made.error().text();
    robot_ = std::move(*made);
  }

  /// Ticks of 8 ms until a condition holds; false if it does not in time.
  template <typename Condition>
  bool until(Condition condition) {
    return eventually(condition, [this] {
      motion_.send();
      input_.now = input_.now + 8;
      robot_->cycle(input_, output_);
    });
  }
  void command(double angle) {
    motion_.jointData.angles[Joint::headPan] = angle;
    EXPECT_TRUE(until([&] { return output_.joints.angles[Joint::headPan] == angle; }));
  }
  /// Waits until commands of all kinds have come that were given from now on.
  void settle() {
    const auto commands = [&] {
      return robot_->statistics().frames - robot_->statistics().missedFrames;
    };
    const std::int64_t before = commands();
    EXPECT_TRUE(until([&] { return commands() > before + 5; }));
  }
  /// Has the odometry make a step; returns how far the robot has come.
  double walk(double step) {
    motion_.odometryData.pose = motion_.odometryData.pose * Pose2D{0, step, 0};
    settle();
    return output_.odometry.pose.translation.x();
  }

  const testing::TestFolder folder_;
  const Task walk_{"Walk", {&representation<JointData>(), &representation<OdometryData>()}, {}};
  Plan plan_;
  std::unique_ptr<RemoteRobot> robot_;
  Motion motion_{RobotAddresses{folder_.file("sockets"), "red1", {}}.endpoint(platformProcess)};
  RobotInput input_;
  RobotOutput output_;
};

TEST_F(RemoteRobotTest, SendsSensorsAndTakesCommands) {
  SensorData frame;
  frame.time = Time{4711};
  input_.sensors.push(frame);
  command(0.5);
  EXPECT_TRUE(until([&] { return motion_.sensorData.newest().time == Time{4711}; }));
  EXPECT_GT(robot_->statistics().frames, 0);
}

TEST_F(RemoteRobotTest, BelievesOnlyWhatItsProcessesProvide) {
  settle();
  EXPECT_EQ(robot_->belief().pose, nullptr) << "nobody localizes";
}

TEST_F(RemoteRobotTest, KeepsItsJointsWhileNobodyAnswersAndCountsThat) {
  command(0.25);
  const RemoteStatistics before = robot_->statistics();
  for (int i = 0; i < 10; ++i) robot_->cycle(input_, output_);
  EXPECT_EQ(output_.joints.angles[Joint::headPan], 0.25);
  EXPECT_GE(robot_->statistics().missedFrames, before.missedFrames + 9) << "one may be on its way";
}

TEST_F(RemoteRobotTest, CommandsThatNoBodyCouldFollowAreDropped) {
  command(0.25);
  for (const double wrong : {4.0, std::numeric_limits<double>::quiet_NaN()}) {
    motion_.jointData.angles[Joint::headTilt] = wrong;
    settle();
    EXPECT_EQ(output_.joints.angles[Joint::headTilt], 0);
  }
}

TEST_F(RemoteRobotTest, WalksByTheStepsOfItsOdometryButNotByAJump) {
  settle();
  EXPECT_NEAR(walk(4), 4, 1e-9);
  EXPECT_NEAR(walk(4), 8, 1e-9);
  EXPECT_NEAR(walk(1e5), 8, 1e-9) << "its program was started anew, with its own origin";
  EXPECT_NEAR(walk(4), 12, 1e-9);
}

}  // namespace
}  // namespace gt
