#include "modules/motion/walking/InvKinWalkingEngine.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/kinematics/LegKinematics.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

/// A walking engine with what it reads, as MotionControl would run it.
struct Walk {
  InvKinWalkingEngine engine;
  MotionRequest request;
  MotionInfo motion;
  RobotDimensions robot;
  WalkingEngineOutput output;

  Walk() { EXPECT_TRUE(readConfig("config/modules/WalkingEngine.InvKin.cfg", engine.parameters)); }
  void frame() { engine.update({}, request, robot, {motion}, output); }
  void frames(int n) {
    for (int i = 0; i < n; ++i) frame();
  }
  void go(double x, double y, double rotation) {
    request.type = MotionType::walk;
    request.walk = {rotation, x, y};
  }
  auto feet() const { return footPositions(robot, output.joints.angles); }
};

const std::array<Pose2D, 7> motions{Pose2D{0, 1000, 0},  Pose2D{0, -1000, 0}, Pose2D{0, 0, 1000},
                                    Pose2D{5, 0, 0},     Pose2D{-5, 0, 0},    Pose2D{1, 120, 0},
                                    Pose2D{0.5, 80, -60}};

TEST(InvKinWalkingEngine, StandsWhenNothingIsRequested) {
  Walk walk;
  walk.frame();
  const auto first = walk.output.joints.angles;
  walk.frames(200);
  EXPECT_EQ(walk.output.joints.angles.values, first.values);
  EXPECT_TRUE(walk.output.mayLeave);
  const auto& p = walk.engine.parameters;
  const auto feet = walk.feet();
  EXPECT_NEAR(feet[0].x(), 59.5 + p.foreCenterX, 1e-6);
  EXPECT_NEAR(feet[0].y(), -p.foreWidth, 1e-6);
  EXPECT_NEAR(feet[3].z(), -p.hindHeight, 1e-6);
}

TEST(InvKinWalkingEngine, ReachesItsSpeeds) {
  const auto speed = [](double x, double y, double rotation) {
    Walk walk;
    walk.go(x, y, rotation);
    walk.frames(400);
    return walk.output.speed;
  };
  EXPECT_GT(speed(1000, 0, 0).translation.x(), 220);
  EXPECT_LT(speed(-1000, 0, 0).translation.x(), -220);
  EXPECT_GT(speed(0, 1000, 0).translation.y(), 150);
  EXPECT_GT(speed(0, 0, 10).rotation, 1.7);
  EXPECT_NEAR(speed(100, 0, 0).translation.x(), 100, 1e-9);
  EXPECT_NEAR(speed(0, 0, -1).rotation, -1, 1e-9);
  const auto both = speed(300, 0, 3);  // clipped, but in the direction requested
  EXPECT_NEAR(both.translation.x() / both.rotation, 100, 1e-6);
}

TEST(InvKinWalkingEngine, OdometryIsTheMotionOfTheFeetOnTheGround) {
  for (const auto& motion : motions) {
    Walk walk;
    walk.go(motion.translation.x(), motion.translation.y(), motion.rotation);
    walk.frames(300);
    // The body's motion seen from the pair of feet that stood at the begin and at the end of a
    // frame.
    Pose2D byFeet, reported;
    auto before = walk.feet();
    for (int i = 0; i < 160; ++i) {
      walk.frame();
      const auto after = walk.feet();
      const double phase = walk.output.positionInWalkCycle;
      const bool first = phase > 1e-9 && phase < 0.5 + 1e-9;  // FL and HR are in the air
      const std::size_t a = first ? 0 : 1, b = first ? 3 : 2;
      const auto line = [](const Vector3d& from, const Vector3d& to) {
        return Pose2D{angleOf((to - from).head<2>()), from.head<2>()};
      };
      byFeet = byFeet * (line(before[a], before[b]) * line(after[a], after[b]).inverse());
      reported = reported * walk.output.odometryStep;
      before = after;
    }
    EXPECT_LT((byFeet.translation - reported.translation).norm(),
              0.01 * reported.translation.norm() + 0.5);
    EXPECT_NEAR(normalize(byFeet.rotation - reported.rotation), 0, 0.01);
  }
}

TEST(InvKinWalkingEngine, StaysWithinTheLimitsOfTheJoints) {
  constexpr double speedFactor = 2.65;  // of Sony's recommendation, as the walks of 2003 needed it
  for (const auto& motion : motions) {
    Walk walk;
    walk.frame();
    auto before = walk.output.joints.angles;
    walk.go(motion.translation.x(), motion.translation.y(), motion.rotation);
    for (int i = 0; i < 500; ++i) {
      if (i == 350) walk.request.type = MotionType::stand;
      walk.frame();
      const auto& now = walk.output.joints.angles;
      for (const auto leg : legs)
        for (int number = 1; number <= 3; ++number) {
          const Joint joint = legJoint(leg, number);
          const auto limits = limitsOf(joint);
          EXPECT_GT(now[joint], limits.low);
          EXPECT_LT(now[joint], limits.high);
          EXPECT_LT(std::abs(now[joint] - before[joint]), limits.speed * speedFactor * 0.008)
              << enumName(joint);
        }
      for (const auto leg : legs)
        EXPECT_GT(now[legJoint(leg, 2)], leastElevator(leg, now[legJoint(leg, 1)]));
      before = now;
    }
  }
}

TEST(InvKinWalkingEngine, MayBeLeftOnlyWithAllFeetOnTheGround) {
  Walk walk;
  walk.engine.parameters.foreFootTilt = walk.engine.parameters.hindFootTilt = 0;
  walk.go(200, 0, 0);
  int chances = 0;
  for (int i = 0; i < 320; ++i) {
    walk.frame();
    const auto feet = walk.feet();
    const double lift =
        std::max(std::abs(feet[0].z() - feet[1].z()), std::abs(feet[2].z() - feet[3].z()));
    EXPECT_EQ(walk.output.mayLeave, lift < 0.5) << lift;
    chances += walk.output.mayLeave ? 1 : 0;
  }
  EXPECT_GE(chances, 8);  // twice a cycle
  EXPECT_LE(chances, 24);
}

TEST(InvKinWalkingEngine, ComesToAStandAndStartsAgain) {
  Walk walk;
  walk.frame();
  const auto stand = walk.output.joints.angles;
  for (int round = 0; round < 3; ++round) {
    walk.go(150, 60, 0.5);
    walk.frames(200 + 7 * round);
    EXPECT_NE(walk.output.joints.angles.values, stand.values);
    walk.request.type = MotionType::stand;
    walk.frames(250);
    for (std::size_t i = 0; i < stand.size(); ++i)
      EXPECT_NEAR(walk.output.joints.angles.values[i], stand.values[i], 0.02);
    EXPECT_EQ(walk.output.odometryStep.translation, Vector2d::Zero());
  }
}

TEST(InvKinWalkingEngine, StartsFromTheStandAfterAnotherMotion) {
  Walk walk;
  walk.frame();
  const auto stand = walk.output.joints.angles;
  walk.go(200, 0, 0);
  walk.frames(133);
  walk.motion.executed.type = MotionType::specialAction;
  walk.frame();
  EXPECT_EQ(walk.output.joints.angles.values, stand.values);
  EXPECT_TRUE(walk.output.mayLeave);
  EXPECT_EQ(walk.output.speed.translation, Vector2d::Zero());
}

TEST(InvKinWalkingEngine, ReportsTheSpeedThatWasMeasured) {
  Walk walk;
  walk.engine.parameters.correctionX = 0.8;
  walk.go(100, 0, 0);
  walk.frames(200);
  EXPECT_NEAR(walk.output.speed.translation.x(), 100, 1e-9);
  const auto before = walk.feet();
  walk.frame();
  const auto after = walk.feet();
  double slowest = 0;  // the feet on the ground move faster than the robot
  for (std::size_t i = 0; i < 4; ++i) slowest = std::min(slowest, after[i].x() - before[i].x());
  EXPECT_NEAR(slowest, -1.0, 0.01);
  EXPECT_NEAR(walk.output.odometryStep.translation.x(), 0.8, 1e-9);
}

TEST(InvKinWalkingEngine, RectanglesWalkAsFar) {
  for (const auto mode : {FootMode::rectangle, FootMode::halfEllipse}) {
    Walk walk;
    walk.engine.parameters.footMode = mode;
    walk.go(150, 0, 0);
    walk.frames(200);
    double highest = -1000, farthest = 0;
    for (int i = 0; i < 80; ++i) {
      walk.frame();
      highest = std::max(highest, walk.feet()[1].z());
      farthest = std::max(farthest, walk.feet()[1].x() - 59.5 - walk.engine.parameters.foreCenterX);
    }
    EXPECT_NEAR(highest, walk.engine.parameters.foreFootLift - walk.engine.parameters.foreHeight,
                2);
    const double onGround = 0.5 * 0.008 * walk.engine.parameters.stepLen;
    EXPECT_NEAR(farthest, 150 * onGround / 2, 0.7);
  }
}

}  // namespace
}  // namespace gt
