#include "simulation/sensors/Sensors.h"

#include <gtest/gtest.h>

#include "support/TestScenes.h"

namespace gt {
namespace {

TEST(Sensors, WithoutNoiseTheyTellTheTruth) {
  const SceneDescription scene = duelScene({}, {1500, 1000});
  const auto world = worldOf(scene);
  run(*world, standingCommand(), 200);
  Sensors sensors{scene.noise, Random{1}};
  SensorData readings;
  sensors.read(*world, 0, readings);
  EXPECT_EQ(readings.time, world->time());
  EXPECT_EQ(readings.joints.values, world->robot(0).joints.values);
  const double tilt = world->robot(0).tilt;
  EXPECT_NE(tilt, 0);
  EXPECT_NEAR(readings.acceleration.x(), 9810 * std::sin(tilt), 1e-6);  // nose up: pressed back
  EXPECT_NEAR(readings.acceleration.y(), 0, 1e-6);
  EXPECT_NEAR(readings.acceleration.z(), 9810 * std::cos(tilt), 1e-6);
  int paws = 0;
  for (const Switch paw : {Switch::pawFR, Switch::pawFL, Switch::pawHR, Switch::pawHL})
    paws += readings.switches[paw];
  EXPECT_EQ(paws, 4);
  EXPECT_FALSE(readings.switches[Switch::chin]);
  sensors.press(Switch::back, true);
  sensors.read(*world, 0, readings);
  EXPECT_TRUE(readings.switches[Switch::back]);
}

TEST(Sensors, AFallIsFelt) {
  const SceneDescription scene = duelScene({}, {1500, 1000});
  const auto world = worldOf(scene);
  world->throwOver(0, Posture::onRightSide);
  run(*world, standingCommand(), 1);
  Sensors sensors{scene.noise, Random{1}};
  SensorData readings;
  sensors.read(*world, 0, readings);
  EXPECT_NEAR(readings.acceleration.y(), 9810, 1e-6);
  EXPECT_FALSE(readings.switches[Switch::pawFL]);
}

TEST(Sensors, TheNoiseIsAsTheSceneSays) {
  SceneDescription scene = duelScene({}, {1500, 1000});
  scene.noise.joints = 0.2;
  scene.noise.acceleration = 200;
  const auto world = worldOf(scene);
  run(*world, standingCommand(), 200);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Sensors sensors{scene.noise, Random{seed}}, again{scene.noise, Random{seed}};
    SensorData readings, same;
    double joint = 0, acceleration = 0;
    constexpr int n = 2000;
    for (int i = 0; i < n; ++i) {
      sensors.read(*world, 0, readings);
      again.read(*world, 0, same);
      ASSERT_EQ(readings.joints.values, same.joints.values);
      const double d = readings.joints[Joint::legFL1] - world->robot(0).joints[Joint::legFL1];
      joint += d * d;
      acceleration += readings.acceleration.y() * readings.acceleration.y();
    }
    EXPECT_NEAR(toDegrees(std::sqrt(joint / n)), 0.2, 0.02);
    EXPECT_NEAR(std::sqrt(acceleration / n), 200, 20);
  }
}

TEST(Sensors, PsdMeasuresTheDistanceToWallBallAndFloor) {
  const SceneDescription scene = duelScene({0, 1000, 700}, {-1500, 1000});
  const auto world = worldOf(scene);
  RobotCommand command = standingCommand();
  const auto measured = [&] {
    run(*world, command, 150);
    return rayDistance(*world, 0, 900);
  };
  command.joints[Joint::headTilt] = -world->robot(0).tilt;
  EXPECT_EQ(measured(), 900);  // over the wall
  // Down to the floor: from the sensor's height along the beam.
  command.joints[Joint::headTilt] = fromDegrees(-40);
  const double floor = measured();
  const Pose3D sensor = sitePose(world->data(), world->parts(0).psdSite);
  EXPECT_NEAR(floor, sensor.translation.z() / -sensor.rotation(2, 0), 1e-6);
  EXPECT_LT(floor, 500);
  // A ball on that spot is nearer.
  const Vector3d spot = sensor * Vector3d{floor, 0, 0};
  world->placeBall(0, {spot.x(), spot.y()});
  EXPECT_LT(measured(), floor - 20);
  EXPECT_GT(measured(), floor - 90);
  // The wall ahead: the ray passes above 100 mm far away, and meets it near by.
  world->placeBall(0, {-1500, 1000});
  world->placeRobot(0, {0, 1900, 700});
  const double wall = measured();
  const Pose3D near = sitePose(world->data(), world->parts(0).psdSite);
  EXPECT_LT(wall, near.translation.z() / -near.rotation(2, 0) - 10);
}

TEST(Sensors, JointsHavePlay) {
  const SceneDescription scene = duelScene({}, {1500, 1000});
  const auto world = worldOf(scene);
  RobotBuild build;
  build.backlash = fromDegrees(2);
  Sensors sensors{scene.noise, Random{1}, build};
  SensorData readings;
  // To and fro: what is measured follows half of the play behind.
  for (const double sign : {1.0, -1.0, 1.0}) {
    RobotCommand command = standingCommand();
    command.joints[Joint::headPan] = sign * 0.5;
    for (int i = 0; i < 150; ++i) {
      run(*world, command, 1);
      sensors.read(*world, 0, readings);
    }
    const double truth = world->robot(0).joints[Joint::headPan];
    EXPECT_NEAR(truth, sign * 0.5, 1e-3);
    EXPECT_NEAR(truth - readings.joints[Joint::headPan], sign * fromDegrees(1), 1e-9);
  }
}

TEST(Sensors, MeasureWhatTheRobotsBuildAddsToIt) {
  const SceneDescription scene = duelScene({}, {1500, 1000});
  const auto world = worldOf(scene);
  run(*world, standingCommand(), 200);
  RobotBuild build;
  build.joints[Joint::headTilt] = fromDegrees(1.5);
  build.acceleration = {100, -50, 20};
  Sensors sensors{scene.noise, Random{1}, build}, exact{scene.noise, Random{1}};
  SensorData readings, right;
  sensors.read(*world, 0, readings);
  exact.read(*world, 0, right);
  EXPECT_NEAR(right.joints[Joint::headTilt] - readings.joints[Joint::headTilt], fromDegrees(1.5),
              1e-12);
  EXPECT_EQ(right.joints[Joint::headPan], readings.joints[Joint::headPan]);
  EXPECT_NEAR((readings.acceleration - right.acceleration - build.acceleration).norm(), 0, 1e-9);
}

TEST(Sensors, ReflectionsFalsifyAShareOfTheDistances) {
  SceneDescription scene = duelScene({}, {1500, 1000});
  const auto world = worldOf(scene);
  run(*world, standingCommand(), 200);
  Sensors exact{scene.noise, Random{1}};
  SensorData readings;
  exact.read(*world, 0, readings);
  const double truth = readings.psd;
  for (const double share : {0.0, 0.05, 0.3}) {
    scene.noise.psdReflections = share;
    Sensors sensors{scene.noise, Random{2}};
    int wrong = 0;
    constexpr int count = 5000;
    for (int i = 0; i < count; ++i) {
      sensors.read(*world, 0, readings);
      EXPECT_GE(readings.psd, 100);
      EXPECT_LE(readings.psd, 900);
      wrong += std::abs(readings.psd - truth) > 1e-9;
    }
    EXPECT_NEAR(wrong / static_cast<double>(count), share, 0.02);
  }
}

}  // namespace
}  // namespace gt
