#include "modules/motion/control/DebugMotionControl.h"

#include <gtest/gtest.h>

#include "modules/motion/control/DefaultMotionControl.h"

namespace gt {
namespace {

/// The module on motors that do at once what they are told, unless somebody holds them.
struct TriedMotion {
  DebugMotionControl module;
  SensorDataBuffer sensors;
  JointDataSequence sequence;
  JointData joints;
  JointGains gains;
  OdometryData odometry;
  MotionInfo info;

  void step() {
    module.update(sensors, sequence, joints, gains, odometry, info);
    SensorData data;
    data.joints = joints.angles;
    sensors.push(data);
  }
  void force(Joint joint, double angle) { sensors.frames.back().joints[joint] = angle; }
  void execute(std::vector<JointDataSequence::Line> lines, bool loop = false) {
    sequence.lines = std::move(lines);
    sequence.loop = loop;
    ++sequence.number;
  }
  static JointDataSequence::Line line(double pan, bool interpolate, int frames) {
    JointDataSequence::Line line;
    line.dontCare.fill(true);
    line.dontCare[static_cast<std::size_t>(Joint::headPan)] = false;
    line.angles[static_cast<std::size_t>(Joint::headPan)] = pan;
    line.interpolate = interpolate;
    line.frames = frames;
    return line;
  }
  double pan() const { return joints.angles[Joint::headPan]; }
};

TEST(DebugMotionControl, StaysAsForced) {
  TriedMotion motion;
  motion.force(Joint::headPan, 0.4);
  motion.step();
  EXPECT_EQ(motion.pan(), 0.4) << "where the joints are when it is switched on";
  motion.force(Joint::headPan, 0.45);  // gives way
  motion.step();
  EXPECT_EQ(motion.pan(), 0.4);
  motion.force(Joint::headPan, 0.7);
  motion.force(Joint::legFL3, 2);
  motion.step();
  EXPECT_EQ(motion.pan(), 0.7);
  EXPECT_EQ(motion.joints.angles[Joint::legFL3], 2);
  EXPECT_FALSE(motion.info.stable);
}

TEST(DebugMotionControl, ExecutesLinesOnceOrInALoopUntilItIsStopped) {
  TriedMotion motion;
  motion.execute({TriedMotion::line(1, false, 1)});
  for (int i = 0; i < 3; ++i) motion.step();
  EXPECT_EQ(motion.pan(), 1) << "sent together with the switch to this solution";
  for (const bool loop : {false, true}) {
    motion.execute({TriedMotion::line(0, false, 1), TriedMotion::line(0.8, true, 8)}, loop);
    motion.step();
    EXPECT_EQ(motion.pan(), 0);
    for (int i = 1; i <= 8; ++i) {
      motion.step();
      EXPECT_NEAR(motion.pan(), 0.1 * i, 1e-9);
    }
    motion.step();
    EXPECT_NEAR(motion.pan(), loop ? 0 : 0.8, 1e-9);
  }
  motion.step();
  EXPECT_NEAR(motion.pan(), 0.1, 1e-9);
  motion.execute({});
  for (int i = 0; i < 10; ++i) motion.step();
  EXPECT_NEAR(motion.pan(), 0.1, 1e-9);
}

TEST(DebugMotionControl, JointsThatStillArriveAreNotTurnedByHand) {
  TriedMotion motion;
  motion.execute({TriedMotion::line(1, false, 1)});
  double measured = 0;
  for (int i = 0; i < 100; ++i) {
    motion.step();
    measured += 0.1 * (motion.pan() - measured);  // a motor that follows slowly
    motion.force(Joint::headPan, measured);
  }
  EXPECT_EQ(motion.pan(), 1);
  motion.force(Joint::headPan, 0.5);
  motion.step();
  EXPECT_EQ(motion.pan(), 0.5);
}

TEST(DebugMotionControl, StaysWithinLimitsAndSurvivesOtherLinesUnderTheSameNumber) {
  TriedMotion motion;
  motion.step();
  motion.execute({TriedMotion::line(9, false, 1), TriedMotion::line(9, true, 5)});
  motion.step();
  EXPECT_NEAR(motion.pan(), fromDegrees(89.6), 1e-9);
  motion.step();
  motion.sequence.lines.clear();
  motion.step();
  EXPECT_NEAR(motion.pan(), fromDegrees(89.6), 1e-9);
}

TEST(DebugMotionControl, TheDefaultSolutionResumesFromWhereItLeftTheRobot) {
  TriedMotion motion;
  motion.odometry.pose = {0.5, 100, 20};
  motion.force(Joint::legHR1, -0.4);
  motion.step();
  EXPECT_EQ(motion.odometry.pose.translation, Vector2d(100, 20));
  DefaultMotionControl byDefault;
  byDefault.update({}, {}, {}, {}, {}, {}, motion.joints, motion.gains, motion.odometry,
                   motion.info);
  EXPECT_NEAR(motion.joints.angles[Joint::legHR1], -0.4, 0.03) << "no jump";
  EXPECT_EQ(motion.odometry.pose.translation, Vector2d(100, 20));
}

}  // namespace
}  // namespace gt
