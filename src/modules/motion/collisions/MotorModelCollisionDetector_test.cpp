#include "modules/motion/collisions/MotorModelCollisionDetector.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

/// Legs that do as they are told at once; one may be held up. A collision is what is off by more
/// than a degree in the mean of all rotators.
struct WatchedLegs {
  WatchedLegs() {
    motion.executed.type = MotionType::walk;
    for (auto* walk : {&detector.parameters.normal, &detector.parameters.fast}) {
      for (auto& motor : walk->motors) motor[0] = 1;
      walk->weights[2 * legJoints + 6] = 10;
      walk->constant = -10 * std::log(fromDegrees(1) / 0.01 + 0.2);
    }
  }
  void run(int frames, double off = 0) {
    for (int i = 0; i < frames; ++i) {
      time.ms += 8;
      sensors.frames.back().time = time;
      for (int leg = 0; leg < 4; ++leg) {
        const Joint rotator = legJoint(static_cast<Leg>(leg), 1);
        joints.angles[rotator] = 0.3 * std::sin(static_cast<double>(time.ms) / 40);
        sensors.frames.back().joints[rotator] = joints.angles[rotator] + (leg == 2 ? off : 0);
      }
      detector.update(sensors, joints, motion, percept, debug);
      debug.out().clear();
      collisions += percept.collision();
    }
  }

  Time time{};
  int collisions = 0;
  MotorModelCollisionDetector detector;
  SensorDataBuffer sensors;
  JointData joints;
  MotionInfo motion;
  CollisionPercept percept;
  Debug debug{1024};
};

TEST(MotorModelCollisionDetector, FindsALegThatIsHeldUp) {
  WatchedLegs walker;
  walker.run(300, fromDegrees(1));
  EXPECT_EQ(walker.collisions, 0) << "half a degree in the mean of four";
  walker.run(60, fromDegrees(4));
  EXPECT_GT(walker.collisions, 0);
  EXPECT_GT(walker.percept.strength, 1);
  EXPECT_TRUE(walker.percept.legs[Leg::hindRight]);
  EXPECT_FALSE(walker.percept.legs[Leg::foreRight]);
  const Time last = walker.percept.lastCollision;
  walker.run(200);
  EXPECT_FALSE(walker.percept.collision());
  EXPECT_FALSE(walker.percept.legs[Leg::hindRight]);
  EXPECT_LT(walker.percept.lastCollision - last, 500);
}

TEST(MotorModelCollisionDetector, WantsSomeFramesInARow) {
  WatchedLegs walker;
  walker.run(300);
  walker.detector.parameters.inARow = 100;
  walker.run(60, fromDegrees(6));
  EXPECT_EQ(walker.collisions, 0);
  walker.run(100, fromDegrees(6));
  EXPECT_GT(walker.collisions, 0);
}

TEST(MotorModelCollisionDetector, WatchesOnlyWalksThatItKnows) {
  for (const WalkType type : {WalkType::normal, WalkType::fast, WalkType::backward}) {
    WatchedLegs walker;
    walker.motion.executed.walkType = type;
    walker.run(300, fromDegrees(6));
    EXPECT_GT(walker.collisions, 0) << static_cast<int>(type);
  }
  for (const WalkType type : {WalkType::dribble, WalkType::turnWithBall, WalkType::crawl}) {
    WatchedLegs walker;
    walker.motion.executed.walkType = type;
    walker.run(300, fromDegrees(6));
    EXPECT_EQ(walker.collisions, 0) << static_cast<int>(type);
    EXPECT_LT(walker.percept.strength, 1);
  }
}

TEST(MotorModelCollisionDetector, TellsNothingInSpecialActions) {
  WatchedLegs walker;
  walker.motion.executed.type = MotionType::specialAction;
  walker.run(300, fromDegrees(6));
  EXPECT_EQ(walker.collisions, 0);
}

}  // namespace
}  // namespace gt
