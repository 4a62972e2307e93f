#include "simulation/world/RobotBuild.h"

#include <gtest/gtest.h>

#include <set>

#include "base/Statistics.h"
#include "simulation/Simulation.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

TEST(RobotBuild, DiffersFromRobotToRobotAsMuchAsTheSceneSays) {
  BodyParameters body;
  body.tilt = 0.8;
  body.roll = 0.5;
  body.jointOffset = 0.4;
  body.accelerationOffset = 150;
  body.cameraLight = 0.05;
  body.cameraColor = 3;
  RunningStatistics tilt, roll, joints, acceleration, light, cb, cr;
  for (std::uint64_t seed = 1; seed <= 900; ++seed) {
    const RobotBuild build = RobotBuild::draw(body, {}, Random{seed});
    tilt.add(toDegrees(build.tilt));
    roll.add(toDegrees(build.roll));
    for (const double offset : build.joints.values) joints.add(toDegrees(offset));
    for (int k = 0; k < 3; ++k) acceleration.add(build.acceleration[k]);
    light.add(build.light);
    cb.add(build.cb);
    cr.add(build.cr);
  }
  const auto expect = [](const RunningStatistics& drawn, double mean, double standardDeviation) {
    EXPECT_NEAR(drawn.mean(), mean, 0.12 * standardDeviation);
    EXPECT_NEAR(drawn.standardDeviation(), standardDeviation, 0.08 * standardDeviation);
  };
  expect(tilt, 0, 0.8);
  expect(roll, 0, 0.5);
  expect(joints, 0, 0.4);
  expect(acceleration, 0, 150);
  expect(light, 1, 0.05);
  expect(cb, 0, 3);
  expect(cr, 0, 3);
}

TEST(RobotBuild, IsTheSameRobotMoreOrLessDifferent) {
  BodyParameters body, twice;
  body.tilt = 1;
  body.cameraColor = 2;
  twice.tilt = 2;
  twice.cameraColor = 4;
  SceneRobot setup;
  setup.bodyTilt = 3;
  const RobotBuild one = RobotBuild::draw(body, setup, Random{5});
  const RobotBuild two = RobotBuild::draw(twice, setup, Random{5});
  EXPECT_NEAR(two.tilt - fromDegrees(3), 2 * (one.tilt - fromDegrees(3)), 1e-12);
  EXPECT_NEAR(two.cb, 2 * one.cb, 1e-12);
  const RobotBuild none = RobotBuild::draw({}, {}, Random{5});
  EXPECT_EQ(none.tilt, 0);
  EXPECT_EQ(none.driven(standing()).values, standing().values);
}

// A body that leans feels gravity from where it leans to, whichever way the robot faces.
TEST(RobotBuild, FeelsGravityAsItsBodyLeans) {
  RobotBody body;
  body.tilt = 0.1;
  body.roll = 0.05;
  RobotBuild build;
  build.tilt = 0.02;
  build.roll = -0.03;
  build.acceleration = {100, -50, 20};
  const Matrix3d leaning =
      rotationX(build.roll) * rotationY(-build.tilt) * rotationY(-body.tilt) * rotationX(body.roll);
  for (const double direction : {0.0, 1.3, -2.5}) {
    body.pose.rotation = direction;
    body.specificForce = body.origin().rotation.transpose() * Vector3d{0, 0, 9810};
    const Vector3d expected = leaning.transpose() * Vector3d{0, 0, 9810} + build.acceleration;
    EXPECT_LT((build.felt(body) - expected).norm(), 1e-6) << direction;
  }
}

/// Stands, and keeps what it measures.
class Standing : public RobotController {
 public:
  void cycle(const RobotInput& input, RobotOutput& output) override {
    output.joints.angles = standing();
    measured = input.sensors.newest();
  }
  SensorData measured;
};

TEST(RobotBuild, OfEachOfEightRobotsIsDifferentAndStaysTheSame) {
  SceneDescription scene = matchScene();
  scene.game.referee = false;
  scene.body.jointOffset = 1;
  scene.body.tilt = 1;
  auto simulation = Simulation::make(scene, 3);
  ASSERT_TRUE(simulation);
  std::set<double> tilts;
  for (std::size_t i = 0; i < 8; ++i) {
    (*simulation)->attach(i, std::make_unique<Standing>());
    tilts.insert((*simulation)->sensors(i).build().tilt);
  }
  EXPECT_EQ(tilts.size(), 8u);
  for (int i = 0; i < 100; ++i) (*simulation)->step();
  for (std::size_t i = 0; i < 8; ++i) {
    // Motors turn joints until they measure what was requested: the truth is what is off.
    const auto& robot = static_cast<const Standing&>(*(*simulation)->controller(i));
    const RobotBuild& build = (*simulation)->sensors(i).build();
    const Joint knee = legJoint(Leg::hindLeft, 3);
    EXPECT_NEAR(robot.measured.joints[knee], standing()[knee], 1e-3);
    EXPECT_NEAR((*simulation)->world().robot(i).joints[knee], standing()[knee] + build.joints[knee],
                1e-3);
  }
  const double before = (*simulation)->sensors(4).build().tilt;
  (*simulation)->change((*simulation)->scene());
  EXPECT_EQ((*simulation)->sensors(4).build().tilt, before);
  SceneDescription straight = (*simulation)->scene();
  straight.body.tilt = 0;
  (*simulation)->change(straight);
  EXPECT_EQ((*simulation)->sensors(4).build().tilt, 0);
}

}  // namespace
}  // namespace gt
