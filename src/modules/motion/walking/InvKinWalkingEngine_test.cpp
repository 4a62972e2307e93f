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
  SensorDataBuffer sensors;
  WalkingEngineOutput output;

  void frame() { engine.update({}, request, robot, sensors, {motion}, output); }
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

constexpr std::array footModes{FootMode::rectangle, FootMode::halfEllipse, FootMode::ellipse,
                               FootMode::oval, FootMode::freeFormQuad};

/// One leg after the other, each in the air for a quarter of a cycle.
void crawl(WalkParameters& walk) {
  walk.legPhase = {{0.75, 0.25, 0.5, 0}};
  walk.foreGroundPhase = walk.hindGroundPhase = 0.75;
  walk.foreLiftPhase = walk.hindLiftPhase = 0.06;
  walk.foreLoweringPhase = walk.hindLoweringPhase = 0.06;
  walk.stepLen = 120;
}

TEST(InvKinWalkingEngine, StandsWhenNothingIsRequested) {
  Walk walk;
  walk.frame();
  const auto first = walk.output.joints.angles;
  walk.frames(200);
  EXPECT_EQ(walk.output.joints.angles.values, first.values);
  EXPECT_TRUE(walk.output.mayLeave);
  const auto& p = walk.engine.parameters.normal;
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
  for (const auto mode : footModes)
    for (const auto& motion : motions) {
      Walk walk;
      walk.engine.parameters.normal.footMode = mode;
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
      // Over whole steps an ellipse goes as far as the others, but not in each frame.
      const double tolerance = mode == FootMode::ellipse ? 8 : 0.5;  // mm
      EXPECT_LT((byFeet.translation - reported.translation).norm(),
                0.01 * reported.translation.norm() + tolerance);
      EXPECT_NEAR(normalize(byFeet.rotation - reported.rotation), 0, 0.03);
    }
}

TEST(InvKinWalkingEngine, StaysWithinTheLimitsOfTheJointsInEveryWalkType) {
  for (std::size_t type = 0; type < enumCount<WalkType>; ++type)
    for (const auto& motion : motions) {
      Walk walk;
      ASSERT_TRUE(readConfig("config/modules/WalkingEngine.InvKin.cfg", walk.engine.parameters));
      walk.request.walkType = static_cast<WalkType>(type);
      walk.frame();
      walk.go(motion.translation.x(), motion.translation.y(), motion.rotation);
      for (int i = 0; i < 500; ++i) {
        if (i == 350) walk.request.type = MotionType::stand;
        walk.frame();
        const auto& now = walk.output.joints.angles;
        for (const auto leg : legs)
          for (int number = 1; number <= 3; ++number) {
            const Joint joint = legJoint(leg, number);
            EXPECT_GE(now[joint], limitsOf(joint).low) << enumNames<WalkType>[type];
            EXPECT_LE(now[joint], limitsOf(joint).high) << enumNames<WalkType>[type];
          }
      }
    }
}

TEST(InvKinWalkingEngine, MayBeLeftOnlyOnceItStands) {
  Walk walk;
  walk.frame();
  const auto stand = walk.output.joints.angles;
  EXPECT_TRUE(walk.output.mayLeave);
  walk.go(200, 0, 0);
  for (int i = 0; i < 320; ++i) {
    walk.frame();
    EXPECT_FALSE(walk.output.mayLeave) << i;
  }
  walk.request.type = MotionType::specialAction;
  int frames = 0;
  while (!walk.output.mayLeave && ++frames < 300) walk.frame();
  EXPECT_LT(frames,
            50 + 1.5 * walk.engine.parameters.normal.stepLen);  // slows down, and ends the step
  for (std::size_t i = 0; i < stand.size(); ++i)
    EXPECT_NEAR(walk.output.joints.angles.values[i], stand.values[i], 0.02);
}

TEST(InvKinWalkingEngine, LeavesOtherTypesInTheStanceOfTheTypeThatIsRequested) {
  Walk walk;
  walk.frame();
  const auto stand = walk.output.joints.angles;
  walk.engine.parameters.dribble.foreCenterX = 50;
  walk.request.walkType = WalkType::dribble;
  walk.go(100, 0, 0);
  walk.frames(300);
  walk.request = {};
  walk.request.type = MotionType::specialAction;
  walk.frames(300);
  EXPECT_TRUE(walk.output.mayLeave);
  for (std::size_t i = 0; i < stand.size(); ++i)
    EXPECT_NEAR(walk.output.joints.angles.values[i], stand.values[i], 0.02);
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

TEST(InvKinWalkingEngine, StandsAsTheRequestedWalkAfterAnotherMotion) {
  Walk walk;
  auto& p = walk.engine.parameters.turnWithBall;
  p.foreCenterX = 80;
  p.foreHeight = 60;
  p.holdsHead = true;
  walk.frame();
  walk.motion.executed.type = MotionType::specialAction;
  walk.go(0, 0, 1);
  walk.request.walkType = WalkType::turnWithBall;
  walk.frame();
  EXPECT_NEAR(walk.feet()[1].x(), 59.5 + 80, 1e-6);
  EXPECT_NEAR(walk.feet()[1].z(), -60, 1e-6);
  EXPECT_TRUE(walk.output.holdsHead);
  walk.request = {};
  walk.frame();
  EXPECT_EQ(walk.output.walkType, WalkType::normal);
  EXPECT_FALSE(walk.output.holdsHead);
}

TEST(InvKinWalkingEngine, ReportsTheSpeedThatWasMeasured) {
  Walk walk;
  walk.engine.parameters.normal.correctionX = 0.8;
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

TEST(InvKinWalkingEngine, ReportsWhatStepsMakeByThemselves) {
  for (const Pose2D& request : {Pose2D{0, -70, 0}, Pose2D{0.3, 60, 20}, Pose2D{-0.3, 0, -40}}) {
    Walk walk;
    auto& p = walk.engine.parameters.normal;
    p.driftX = 20;
    p.turnCenter = -15;
    p.counterRotation = 0.001;
    p.correctionY = 1.1;
    walk.go(request.translation.x(), request.translation.y(), request.rotation);
    walk.frames(200);
    EXPECT_NEAR((walk.output.speed.translation - request.translation).norm(), 0, 1e-9);
    EXPECT_NEAR(walk.output.speed.rotation, request.rotation, 1e-9);
  }
  Walk stands;
  stands.engine.parameters.normal.driftX = 20;
  stands.go(0, 0, 0);
  stands.frames(200);
  EXPECT_EQ(stands.output.speed.translation.x(), 0);
}

TEST(InvKinWalkingEngine, FeetMoveAgainstTheDrift) {
  Walk walk;
  walk.engine.parameters.normal.driftX = 20;
  walk.go(-70, 0, 0);
  walk.frames(200);
  const auto before = walk.feet();
  walk.frame();
  const auto after = walk.feet();
  double fastest = 0;
  for (std::size_t i = 0; i < 4; ++i) fastest = std::max(fastest, after[i].x() - before[i].x());
  EXPECT_NEAR(fastest, 90 * 0.008, 0.01);
}

TEST(InvKinWalkingEngine, EveryFootModeWalksAsHighAndFarAsItsParametersSay) {
  for (const auto mode : footModes) {
    Walk walk;
    auto& p = walk.engine.parameters.normal;
    p.footMode = mode;
    p.foreFootTilt = 0;
    p.foreFootLift = p.foreFreeFormQuadPos[2].z();
    walk.go(150, 0, 0);
    walk.frames(200);
    double highest = -1000, lowest = 1000, farthest = 0;
    for (int i = 0; i < 80; ++i) {
      walk.frame();
      const Vector3d foot = walk.feet()[1];
      highest = std::max(highest, foot.z() + p.foreHeight);
      lowest = std::min(lowest, foot.z() + p.foreHeight);
      farthest = std::max(farthest, foot.x() - 59.5 - p.foreCenterX);
    }
    const double half = mode == FootMode::ellipse ? p.foreFootLift / 2 : 0;
    EXPECT_NEAR(highest, p.foreFootLift - half, 1) << static_cast<int>(mode);
    EXPECT_NEAR(lowest, -half, 0.5) << static_cast<int>(mode);
    const double onGround = 0.5 * 0.008 * p.stepLen;
    const double circle = mode == FootMode::oval ? p.foreFootLift / 2 : 0;
    EXPECT_NEAR(farthest, 150 * onGround / 2 + circle, 0.9) << static_cast<int>(mode);
  }
}

TEST(InvKinWalkingEngine, StartsAndStopsWithoutAJerkInEveryFootModeAndGait) {
  for (const auto mode : footModes)
    for (const bool crawls : {false, true}) {
      Walk walk;
      walk.engine.parameters.normal.footMode = mode;
      walk.engine.parameters.normal.bodyShiftY = 8;
      if (crawls) crawl(walk.engine.parameters.normal);
      walk.frame();
      const auto stand = walk.feet();
      auto before = stand;
      for (int i = 0; i < 900; ++i) {
        if (i == 20) walk.go(100, 30, 0.3);
        if (i == 333) walk.go(-80, 0, 0);
        if (i == 500) walk.request.type = MotionType::stand;
        walk.frame();
        const auto now = walk.feet();
        for (std::size_t f = 0; f < now.size(); ++f)
          EXPECT_LT((now[f] - before[f]).norm(), 12) << static_cast<int>(mode) << " " << i;
        before = now;
      }
      for (std::size_t f = 0; f < stand.size(); ++f)
        EXPECT_LT((before[f] - stand[f]).norm(), 1) << static_cast<int>(mode);
    }
}

TEST(InvKinWalkingEngine, TheBodyMovesAwayFromAFootBeforeItIsLifted) {
  Walk walk;
  crawl(walk.engine.parameters.normal);
  auto& p = walk.engine.parameters.normal;
  p.foreFootTilt = p.hindFootTilt = 0;
  p.bodyShiftX = 10;
  p.bodyShiftY = 20;
  p.bodyShiftOffset = 0.1;
  walk.go(1e-6, 0, 0);  // in place
  walk.frames(3 * p.stepLen);
  const std::array phases{0.75, 0.25, 0.5, 0.};
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    // When the body is moved farthest: a tenth before the middle of the leg's time in the air.
    while (std::abs(walk.output.positionInWalkCycle - (phases[leg] + 0.025)) > 1e-3) walk.frame();
    const double x = isFore(legs[leg]) ? 10 : -10, y = isLeft(legs[leg]) ? 20 : -20;
    for (std::size_t other = 0; other < legs.size(); ++other) {
      const Vector3d foot = walk.feet()[other];
      const double centerX = isFore(legs[other]) ? 59.5 + p.foreCenterX : -59.5 + p.hindCenterX;
      EXPECT_NEAR(foot.x() - centerX, x, 0.6);
      EXPECT_NEAR(std::abs(foot.y()) - p.foreWidth, isLeft(legs[other]) ? y : -y, 1.2);
    }
  }
}

TEST(InvKinWalkingEngine, AcceleratesNoMoreThanItMay) {
  Walk walk;
  auto& p = walk.engine.parameters.normal;
  p.maxSpeedXChange = 200;
  p.maxSpeedYChange = 100;
  p.maxRotationChange = 2;
  walk.frame();
  walk.go(1000, 1000, 10);
  Pose2D before = walk.output.speed;
  for (int i = 0; i < 100; ++i) {
    walk.frame();
    const Pose2D change{walk.output.speed.rotation - before.rotation,
                        walk.output.speed.translation - before.translation};
    EXPECT_LE(change.translation.x(), 200 * 0.008 + 1e-9);
    EXPECT_LE(change.translation.y(), 100 * 0.008 + 1e-9);
    EXPECT_LE(change.rotation, 2 * 0.008 + 1e-9);
    before = walk.output.speed;
  }
}

TEST(InvKinWalkingEngine, HindLegsHaveTheirShareOfTheSpeed) {
  const auto steps = [](double x, double y, double rotation) {
    Walk walk;
    auto& p = walk.engine.parameters.normal;
    p.legSpeedFactorX = 0.5;
    p.legSpeedFactorY = 0.4;
    p.legSpeedFactorR = 0.6;
    walk.go(x, y, rotation);
    walk.frames(200);
    std::array<Vector3d, 4> low = walk.feet(), high = low;
    for (int i = 0; i < p.stepLen; ++i) {
      walk.frame();
      for (std::size_t f = 0; f < 4; ++f) {
        low[f] = low[f].cwiseMin(walk.feet()[f]);
        high[f] = high[f].cwiseMax(walk.feet()[f]);
      }
    }
    return std::array{Vector3d{high[0] - low[0]}, Vector3d{high[2] - low[2]}};
  };
  const auto ahead = steps(80, 0, 0), aside = steps(0, 80, 0), turning = steps(0, 0, 0.8);
  EXPECT_NEAR(ahead[1].x() / ahead[0].x(), 0.5, 0.05);
  EXPECT_NEAR(aside[1].y() / aside[0].y(), 0.4, 0.05);
  EXPECT_NEAR(turning[1].y() / turning[0].y(), 0.6, 0.1);
}

TEST(InvKinWalkingEngine, CounterRotationTurnsWhileItWalksSideways) {
  Walk walk;
  walk.engine.parameters.normal.counterRotation = 0.002;
  walk.go(0, 100, 0);
  walk.frames(200);
  EXPECT_NEAR(walk.output.speed.rotation, 0, 1e-9);  // what it should turn is not reported
  const auto before = walk.feet();
  walk.frame();
  const auto after = walk.feet();
  // A foot on the ground fore moves to the right more slowly than one behind.
  const double fore = std::min(after[0].y() - before[0].y(), after[1].y() - before[1].y());
  const double hind = std::min(after[2].y() - before[2].y(), after[3].y() - before[3].y());
  EXPECT_LT(fore, hind);
}

TEST(InvKinWalkingEngine, FootTiltRaisesTheFrontOfThePath) {
  Walk walk;
  auto& p = walk.engine.parameters.normal;
  p.foreFootTilt = 0.2;
  p.hindFootTilt = -0.1;
  walk.go(100, 0, 0);
  walk.frames(300);
  for (int i = 0; i < p.stepLen; ++i) {
    walk.frame();
    const auto feet = walk.feet();
    for (std::size_t f = 0; f < 4; ++f) {
      const bool fore = f < 2;
      const double ahead = feet[f].x() - (fore ? 59.5 + p.foreCenterX : -59.5 + p.hindCenterX);
      const double height = feet[f].z() + (fore ? p.foreHeight : p.hindHeight);
      EXPECT_GE(height, ahead * std::tan(fore ? 0.2 : -0.1) - 0.05);
    }
  }
}

TEST(InvKinWalkingEngine, MayHoldTheHead) {
  Walk walk;
  walk.frame();
  EXPECT_FALSE(walk.output.holdsHead);
  auto& p = walk.engine.parameters.normal;
  p.holdsHead = true;
  p.headTilt = -0.6;
  p.headPan = 0.1;
  p.headRoll = 0.2;
  p.mouth = -0.5;
  walk.frame();
  EXPECT_TRUE(walk.output.holdsHead);
  EXPECT_EQ(walk.output.joints.angles[Joint::headTilt], -0.6);
  EXPECT_EQ(walk.output.joints.angles[Joint::headPan], 0.1);
  EXPECT_EQ(walk.output.joints.angles[Joint::headRoll], 0.2);
  EXPECT_EQ(walk.output.joints.angles[Joint::mouth], -0.5);
}

TEST(InvKinWalkingEngine, ChangesItsWalkTypeBetweenStepsWithoutAJerk) {
  Walk walk;
  auto& p = walk.engine.parameters;
  p.fast = p.normal;
  p.fast.foreHeight = 120;
  p.fast.foreCenterX = 30;
  p.fast.stepLen = 30;
  p.fast.foreGroundPhase = p.fast.hindGroundPhase = 0.45;  // it flies
  walk.frame();
  auto before = walk.feet();
  int changes = 0;
  for (int i = 0; i < 900; ++i) {
    walk.go(150, 0, 0);
    walk.request.walkType = i % 300 < 150 ? WalkType::normal : WalkType::fast;
    const WalkType type = walk.output.walkType;
    walk.frame();
    const auto now = walk.feet();
    if (walk.output.walkType != type) {
      ++changes;
      for (const Vector3d& foot : before) EXPECT_LT(foot.z(), -100);  // all were on the ground
    }
    for (std::size_t f = 0; f < now.size(); ++f) EXPECT_LT((now[f] - before[f]).norm(), 12) << i;
    before = now;
  }
  EXPECT_EQ(changes, 5);
  EXPECT_EQ(walk.output.walkType, WalkType::fast);
  walk.request.type = MotionType::stand;
  walk.frames(200);
  EXPECT_EQ(walk.output.walkType, WalkType::fast);  // it stands as it walked
  EXPECT_NEAR(walk.feet()[1].z(), -120, 1);
  EXPECT_NEAR(walk.feet()[1].x(), 59.5 + 30, 1);
}

TEST(InvKinWalkingEngine, StandsUntilTheLegsHaveArrived) {
  Walk walk;
  walk.motion.arriving = true;
  walk.go(150, 0, 0);
  walk.frame();
  const auto stand = walk.output.joints.angles;
  walk.frames(100);
  EXPECT_EQ(walk.output.joints.angles.values, stand.values);
  walk.motion.arriving = false;
  walk.frames(100);
  EXPECT_NE(walk.output.joints.angles.values, stand.values);
}

}  // namespace
}  // namespace gt
