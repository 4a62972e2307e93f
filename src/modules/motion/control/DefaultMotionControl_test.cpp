#include "modules/motion/control/DefaultMotionControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/Random.h"
#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/testing/MotionHarness.h"

namespace gt {
namespace {

constexpr std::array allLegs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

TEST(DefaultMotionControl, StandsWithoutARequest) {
  MotionHarness motion;
  motion.steps(200);
  EXPECT_EQ(motion.info.executed.type, MotionType::stand);
  EXPECT_TRUE(motion.info.stable);
  for (const auto leg : allLegs)
    EXPECT_NEAR(motion.joints.angles[legJoint(leg, 3)],
                motion.walking.joints.angles[legJoint(leg, 3)], 1e-9);
  EXPECT_EQ(motion.odometry.pose.translation, Vector2d::Zero());
}

TEST(DefaultMotionControl, WalksAsFarAsRequested) {
  MotionHarness motion;
  motion.steps(100);
  motion.walk(150, 0, 0);
  motion.steps(625);  // 5 s
  EXPECT_EQ(motion.info.executed.type, MotionType::walk);
  EXPECT_EQ(motion.info.executed.walk.translation, (Vector2d{150, 0}));
  EXPECT_NEAR(motion.odometry.pose.translation.x(), 750, 40);  // less while it accelerates
  EXPECT_NEAR(motion.odometry.pose.rotation, 0, 1e-9);
}

TEST(DefaultMotionControl, StandsWhenTheBehaviorHasStopped) {
  MotionHarness motion;
  motion.walk(150, 0, 0);
  for (int i = 0; i < 250; ++i) {
    motion.request.time = motion.frame.time;
    motion.step();
  }
  EXPECT_EQ(motion.info.executed.type, MotionType::walk);
  motion.steps(62);  // not yet
  EXPECT_EQ(motion.info.executed.type, MotionType::walk);
  motion.steps(300);
  EXPECT_EQ(motion.info.executed.type, MotionType::stand);
}

TEST(DefaultMotionControl, StandsBeforeASpecialActionAndTheActionBeforeAWalk) {
  for (const int lead : {120, 137, 151}) {
    MotionHarness motion;
    motion.walk(200, 0, 0);
    motion.steps(lead);
    motion.perform("pushStrong");
    int waited = 0;
    while (!motion.performs("pushStrong") && waited < 200) {
      motion.step();
      ++waited;
    }
    EXPECT_LE(waited, 50 + 1.5 * motion.walkingEngine.parameters.normal.stepLen);
    motion.walk(100, 0, 0);
    int performed = 0;
    bool unstable = true;
    while (motion.performs("pushStrong") && performed < 1000) {
      unstable = unstable && !motion.info.stable;
      motion.step();
      ++performed;
    }
    EXPECT_TRUE(unstable);
    EXPECT_GT(performed, 100);  // the whole kick, once
    EXPECT_LT(performed, 250);
    EXPECT_EQ(motion.info.executed.type, MotionType::walk);
  }
}

TEST(DefaultMotionControl, GetsUpAndTellsSo) {
  MotionHarness motion;
  motion.request.type = MotionType::getup;
  motion.steps(20);
  EXPECT_EQ(motion.info.executed.type, MotionType::getup);
  EXPECT_FALSE(motion.info.stable);
  motion.request = {};
  motion.steps(500);
  EXPECT_EQ(motion.info.executed.type, MotionType::stand);
}

TEST(DefaultMotionControl, JointsStayWithinLimitsWhateverIsRequested) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random{seed};
    MotionHarness motion;
    motion.step();
    for (int i = 0; i < 4000; ++i) {
      if (i % 40 == 0) {
        motion.request.type = static_cast<MotionType>(random.index(enumCount<MotionType>));
        motion.request.walk = {random.uniform(-9, 9), random.uniform(-900, 900),
                               random.uniform(-900, 900)};
        // What gets up from the back ends on a side: nothing but the getup engine goes on from
        // there.
        do
          motion.request.specialAction =
              motion.net.motions[random.index(motion.net.motions.size())].name;
        while (motion.request.specialAction == getupFromBack);
        motion.head = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3),
                       random.uniform(-3, 3)};
      }
      const auto before = motion.joints.angles;
      motion.step();
      for (std::size_t j = 0; j < before.size(); ++j) {
        const auto limits = limitsOf(static_cast<Joint>(j));
        const double angle = motion.joints.angles.values[j];
        ASSERT_TRUE(angle >= limits.low && angle <= limits.high) << enumName(static_cast<Joint>(j));
        // Legs are hurried by walks and special actions, and follow as fast as their servos can.
        if (j < 3) {
          const auto& most = motion.motionControl.parameters;
          const double speed = motion.info.executed.type == MotionType::specialAction
                                   ? most.actionSpeed
                               : j == 0 ? most.headTiltSpeed
                                        : most.headPanSpeed;
          ASSERT_LE(std::abs(angle - before.values[j]), 1.01 * speed * 0.008)
              << enumName(static_cast<Joint>(j)) << " in frame " << i;
        }
      }
    }
  }
}

TEST(DefaultMotionControl, ActionsTurnTheHeadFasterThanItLooksAround) {
  for (const int frames : {32, 10}) {
    MotionHarness motion;
    motion.steps(150);
    constexpr double turn = 1.2;  // rad
    const int shakeHead = motion.net.find("shakeHead");
    const auto first = std::ranges::find_if(motion.net.nodes, [&](const MotionNet::Node& node) {
      return node.kind == MotionNodeKind::data && node.motion == shakeHead;
    });
    ASSERT_NE(first, motion.net.nodes.end());
    const auto pan = static_cast<std::size_t>(Joint::headPan);
    first->angles[pan] = turn;
    first->dontCare[pan] = false;
    first->interpolate = true;
    first->frames = frames;
    motion.perform("shakeHead");
    double fastest = 0;  // rad/s
    for (int i = 0; i < 10 + frames; ++i) {
      const double before = motion.joints.angles[Joint::headPan];
      motion.step();
      fastest = std::max(fastest, (motion.joints.angles[Joint::headPan] - before) / 0.008);
    }
    const double limit = motion.motionControl.parameters.actionSpeed;
    EXPECT_NEAR(fastest, std::min(turn / (0.008 * frames), limit), 0.01) << frames;
  }
}

TEST(DefaultMotionControl, TheHeadIsFreeUnlessAnActionNeedsIt) {
  MotionHarness motion;
  motion.head = {-0.3, 0.8, 0, -0.1};
  motion.steps(150);
  EXPECT_NEAR(motion.joints.angles[Joint::headPan], 0.8, 1e-9);
  motion.perform("sit");
  motion.steps(60);
  ASSERT_TRUE(motion.performs("sit"));
  EXPECT_NEAR(motion.joints.angles[Joint::headPan], 0.8, 1e-9);
  motion.request = {};
  motion.steps(300);
  motion.perform("swingLeft");
  motion.steps(125);
  ASSERT_TRUE(motion.performs("swingLeft"));
  EXPECT_LT(motion.joints.angles[Joint::headPan], -0.4);
}

TEST(DefaultMotionControl, AWalkMayHoldTheHead) {
  MotionHarness motion;
  motion.head = {-0.3, 0.8, 0, -0.1};
  motion.walkingEngine.parameters.normal.holdsHead = true;
  motion.walkingEngine.parameters.normal.headTilt = -0.6;
  motion.walk(100, 0, 0);
  motion.steps(200);
  EXPECT_NEAR(motion.joints.angles[Joint::headPan], 0, 1e-9);
  EXPECT_NEAR(motion.joints.angles[Joint::headTilt], -0.6, 1e-9);
}

TEST(DefaultMotionControl, WalksOnceTheLegsHaveArrivedAtTheStand) {
  MotionHarness motion;
  motion.walk(100, 0, 0);
  JointAngles stand;
  int frames = 0;
  for (motion.step(); motion.info.arriving; motion.step()) {
    stand = motion.joints.angles;
    ASSERT_LT(++frames, 200);
  }
  EXPECT_GT(frames, 50);
  for (const auto leg : allLegs)
    EXPECT_NEAR(stand[legJoint(leg, 3)], motion.walking.joints.angles[legJoint(leg, 3)], 1e-9);
  EXPECT_EQ(motion.odometry.pose.translation, Vector2d::Zero());
  motion.steps(100);
  EXPECT_GT(motion.odometry.pose.translation.x(), 40);
}

TEST(DefaultMotionControl, WagsTheTail) {
  const auto widest = [](TailRequest tail, Joint joint) {
    MotionHarness motion;
    motion.request.tail = tail;
    double least = 0, most = 0;
    for (int i = 0; i < 500; ++i) {
      motion.step();
      least = std::min(least, motion.joints.angles[joint]);
      most = std::max(most, motion.joints.angles[joint]);
    }
    EXPECT_NEAR(least, -most, 0.01) << "to both sides";
    return most;
  };
  EXPECT_EQ(widest(TailRequest::noTailWag, Joint::tailPan), 0);
  EXPECT_GT(widest(TailRequest::wagHorizontal, Joint::tailPan), 0.2);
  EXPECT_EQ(widest(TailRequest::wagHorizontal, Joint::tailTilt), 0);
  EXPECT_GT(widest(TailRequest::wagVertical, Joint::tailTilt), 0.2);
  EXPECT_EQ(widest(TailRequest::wagVertical, Joint::tailPan), 0);
}

}  // namespace
}  // namespace gt
