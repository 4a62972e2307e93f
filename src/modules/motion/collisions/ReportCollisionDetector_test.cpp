#include "modules/motion/collisions/ReportCollisionDetector.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

/// Legs that swing as commanded, some frames late; one may be held up.
struct Walker {
  explicit Walker(int phaseShift) : shift{phaseShift} {
    motion.executed.type = MotionType::walk;
    motion.executed.walk.translation = {150, 0};
  }
  double angle(int frame) const { return 0.4 * std::sin(2 * pi * frame / 80.); }
  void run(int frames, bool held = false) {
    for (int i = 0; i < frames; ++i, ++n) {
      for (int leg = 0; leg < 4; ++leg)
        for (const int joint : {1, 2}) {
          const Joint j = legJoint(static_cast<Leg>(leg), joint);
          joints.angles[j] = angle(n + 20 * leg);
          const double follows = held && leg == 1 ? 0.4 : 1;
          sensors.frames.back().joints[j] =
              follows * angle(n + 20 * leg - shift) + fromDegrees(0.3) * random.gaussian();
        }
      sensors.frames.back().time = Time{8 * n};
      detector.update(sensors, joints, motion, percept, debug);
      collisions += percept.collision();
      strongest = std::max(strongest, percept.strength);
    }
  }

  int shift, n = 0, collisions = 0;
  double strongest = 0;
  Random random{1};
  ReportCollisionDetector detector;
  SensorDataBuffer sensors;
  JointData joints;
  MotionInfo motion;
  CollisionPercept percept;
  Debug debug{1024};
};

TEST(ReportCollisionDetector, APhaseShiftIsNoCollision) {
  for (const int shift : {1, 3, 5, 8}) {
    Walker walker{shift};
    walker.run(500);
    EXPECT_EQ(walker.collisions, 0) << shift << ' ' << walker.strongest;
  }
}

TEST(ReportCollisionDetector, ALegThatIsHeldUpIsOne) {
  Walker walker{3};
  walker.run(200);
  ASSERT_EQ(walker.collisions, 0);
  walker.run(62, true);  // Half a second.
  EXPECT_GT(walker.collisions, 0);
  walker.run(15, false);
  EXPECT_FALSE(walker.percept.collision());
  EXPECT_GT(walker.percept.lastCollision.ms, 1600);
  EXPECT_LT(walker.percept.lastCollision.ms, 1600 + 8 * 80);
}

TEST(ReportCollisionDetector, TellsWhichLeg) {
  Walker walker{3};
  walker.run(200);
  bool seen = false;
  for (int i = 0; i < 80; ++i) {
    walker.run(1, true);
    seen = seen || walker.percept.legs[Leg::foreLeft];
    EXPECT_FALSE(walker.percept.legs[Leg::hindRight]);
  }
  EXPECT_TRUE(seen);
}

TEST(ReportCollisionDetector, SuddenChangesOfTheCommandsDoNotCount) {
  Walker walker{3};
  walker.run(200);
  walker.motion.executed.walk.translation = {-150, 0};
  walker.run(30, true);
  EXPECT_EQ(walker.collisions, 0);
  walker.run(60, true);
  EXPECT_GT(walker.collisions, 0) << "after they have settled";
}

TEST(ReportCollisionDetector, FindsItsThresholdByGaitAndSpeed) {
  using Detector = ReportCollisionDetector;
  const auto place = [](const Pose2D& walk) {
    MotionRequest motion;
    motion.type = MotionType::walk;
    motion.walk = walk;
    return Detector::placeOf(motion);
  };
  EXPECT_EQ(place({0, 150, 20}).gait, Gait::forward);
  EXPECT_EQ(place({0, 150, 20}).speed, 3u);
  EXPECT_EQ(place({0, -50, 20}).gait, Gait::backward);
  EXPECT_EQ(place({0.1, 0, -1000}).gait, Gait::sideways);
  EXPECT_EQ(place({0.1, 0, -1000}).speed, Detector::speeds - 1);
  EXPECT_EQ(place({-0.6, 40, 0}).gait, Gait::turning);
  EXPECT_EQ(place({-0.6, 40, 0}).speed, 2u);
  EXPECT_EQ(Detector::placeOf({}).gait, Gait::standing);
}

TEST(ReportCollisionDetector, SpecialActionsAreNotWatched) {
  Walker walker{3};
  walker.motion.executed.type = MotionType::specialAction;
  walker.run(300, true);
  EXPECT_EQ(walker.collisions, 0);
}

}  // namespace
}  // namespace gt
