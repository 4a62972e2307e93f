#include "modules/motion/collisions/CollisionFeatures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gt {
namespace {

/// Legs whose joints are where they were commanded some frames ago, and models that know it.
struct Legs {
  explicit Legs(std::size_t late = 3) : late{late} {
    motion.executed.type = MotionType::walk;
    motion.executed.walk = {0.5, 100, -40};
    for (auto& motor : motors) motor[late] = 1;
  }
  double command(std::size_t joint, int frame) const {
    return 0.3 * std::sin(0.2 * frame + static_cast<double>(joint));
  }
  void run(int count) {
    for (int i = 0; i < count; ++i, ++n) {
      for (std::size_t j = 0; j < legJoints; ++j) {
        joints.angles.values[firstLegJoint + j] = command(j, n);
        measured.joints.values[firstLegJoint + j] =
            command(j, n - static_cast<int>(late)) + (j == off ? by : 0);
      }
      measured.acceleration = {shaking * (n % 2 ? 1 : -1), 0, 9810};
      features.add(measured, joints, motion, motors);
    }
  }
  /// The logarithm of what a joint is off, in the longer window.
  double offOf(std::size_t joint) const { return features.values()[legJoints + joint]; }
  double state(std::size_t i) const { return features.values()[2 * legJoints + i]; }

  std::size_t late;
  int n = 0;
  std::size_t off = legJoints;
  double by = 0, shaking = 0;
  LegMotors motors{};
  SensorData measured;
  JointData joints;
  MotionInfo motion;
  CollisionFeatures features;
};

TEST(CollisionFeatures, TellHowFarAJointIsFromWhereItsMotorWouldBeFree) {
  Legs legs;
  legs.run(200);
  const double nothing = std::log(0.2);
  for (std::size_t j = 0; j < legJoints; ++j) EXPECT_NEAR(legs.offOf(j), nothing, 1e-9);
  legs.off = 4, legs.by = 0.02;
  legs.run(50);
  for (std::size_t j = 0; j < legJoints; ++j)
    EXPECT_NEAR(legs.offOf(j), j == 4 ? std::log(2.2) : nothing, 1e-9) << j;
  EXPECT_EQ(legs.features.mostOff(), Leg::foreLeft);
  // The elevators of all legs together: a quarter of the mean square.
  EXPECT_NEAR(legs.state(7), std::log(1.2), 1e-9);
  legs.off = legJoints;
  legs.run(20);
  EXPECT_NEAR(legs.features.values()[4], nothing, 1e-9) << "the shorter window has forgotten it";
  EXPECT_NEAR(legs.offOf(4), std::log(2 * std::sqrt(0.6) + 0.2), 1e-9) << "the longer one has not";
}

TEST(CollisionFeatures, TellHowTheBodyShakesAndWalks) {
  Legs legs;
  legs.shaking = 1000;
  legs.run(200);
  EXPECT_NEAR(legs.state(3), std::log(0.7), 1e-9);
  EXPECT_NEAR(legs.state(5), std::log(0.2), 1e-9) << "gravity does not shake";
  EXPECT_NEAR(legs.state(12), 0.5, 1e-9);
  EXPECT_NEAR(legs.state(13), 0.2, 1e-9);
  EXPECT_NEAR(legs.state(14), 0.5, 1e-9);
  EXPECT_EQ(legs.state(15), 0);
  legs.motion.executed.walk.translation.x() = 0;
  legs.run(30);
  EXPECT_NEAR(legs.state(15), 0, 1e-9);
  EXPECT_NEAR(legs.state(16), 0.5, 1e-9) << "50 frames ago it was faster";
}

TEST(CollisionFeatures, BeginAnewWhereLegsDoNotWalkAsBefore) {
  constexpr int enough = static_cast<int>(CollisionFeatures::frames);
  const auto changed = [](const auto& change) {
    Legs legs;
    legs.run(enough - 1);
    EXPECT_FALSE(legs.features.ready());
    legs.run(1);
    EXPECT_TRUE(legs.features.ready());
    change(legs.motion);
    legs.run(1);
    return !legs.features.ready();
  };
  EXPECT_TRUE(changed([](MotionInfo& m) { m.executed.walkType = WalkType::dribble; }));
  EXPECT_TRUE(changed([](MotionInfo& m) { m.executed.type = MotionType::specialAction; }));
  EXPECT_TRUE(changed([](MotionInfo& m) { m.executed.type = MotionType::getup; }));
  EXPECT_TRUE(changed([](MotionInfo& m) { m.arriving = true; }));
  EXPECT_FALSE(changed([](MotionInfo& m) { m.executed.type = MotionType::stand; }));
  EXPECT_FALSE(changed([](MotionInfo& m) { m.executed.walk = {}; }));
}

TEST(CollisionFeatures, KeepTheLastCommands) {
  Legs legs;
  legs.run(100);
  const auto commands = legs.features.commandsOf(7);
  for (std::size_t k = 0; k < commands.size(); ++k)
    EXPECT_EQ(commands[k], legs.command(7, 99 - static_cast<int>(k)));
}

}  // namespace
}  // namespace gt
