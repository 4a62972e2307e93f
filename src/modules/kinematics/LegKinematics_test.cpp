#include "modules/kinematics/LegKinematics.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "base/NumericJacobian.h"
#include "base/Random.h"

namespace gt {
namespace {

constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

LegAngles randomAngles(Random& random, Leg leg) {
  const auto draw = [&](int number, double low) {
    const auto limits = limitsOf(legJoint(leg, number));
    return random.uniform(std::max(limits.low, low), limits.high);
  };
  // The solution bends the knee to the side where it is freer: beyond straight.
  const double straight = isFore(leg) ? fromDegrees(27.28) : fromDegrees(33.82);
  return {draw(1, -pi), draw(2, -pi), draw(3, straight)};
}

TEST(LegKinematics, FootAtZeroIsWhereTheDrawingHasIt) {
  const RobotDimensions robot;
  EXPECT_LT((footPosition(robot, Leg::foreLeft, {}) - Vector3d{53.42, 59.7, -130.0}).norm(), 1e-9);
  EXPECT_LT((footPosition(robot, Leg::hindRight, {}) - Vector3d{-42.94, -59.7, -134.88}).norm(),
            1e-9);
  // The drawn pose has the knees at 35 degrees (facts, 1.1).
  const auto foot = footPosition(robot, Leg::foreLeft, {0, 0, fromDegrees(35)});
  EXPECT_LT((foot - Vector3d{59.5 + 12.8 + 22.4, 59.7, -64 - 64.9}).norm(), 0.1);
}

TEST(LegKinematics, TheDerivativesOfFootAndAnglesAreInverse) {
  const RobotDimensions robot;
  Random random{4};
  for (const Leg leg : legs)
    for (int i = 0; i < 50; ++i) {
      const LegAngles drawn = randomAngles(random, leg);
      const Vector3d q{drawn.rotator, drawn.elevator, drawn.knee};
      const auto foot = [&](const Vector3d& a) -> Vector3d {
        return footPosition(robot, leg, {a.x(), a.y(), a.z()});
      };
      const auto angles = [&](const Vector3d& place) {
        const LegAngles a = legAngles(robot, leg, place).angles;
        return Vector3d{a.rotator, a.elevator, a.knee};
      };
      const Matrix3d byAngles = numericJacobian(foot, q, Vector3d{1e-5, 1e-5, 1e-5});
      // A stretched leg, or one whose foot lies on the rotator's axis, has no derivative.
      if (std::abs(byAngles.determinant()) < 3e4 || (angles(foot(q)) - q).norm() > 1e-6) continue;
      const Matrix3d byFoot = numericJacobian(angles, foot(q), Vector3d{1e-4, 1e-4, 1e-4});
      EXPECT_LT((byFoot * byAngles - Matrix3d::Identity()).norm(), 1e-3) << q.transpose();
    }
}

/// Equation 3.24 for the left fore leg.
Vector3d byReport(double l1, double l2, double q1, double q2, double q3) {
  return {cos(q1) * sin(q3) * l2 + sin(q1) * cos(q2) * cos(q3) * l2 + sin(q1) * cos(q2) * l1,
          sin(q2) * l1 + sin(q2) * cos(q3) * l2,
          sin(q1) * sin(q3) * l2 - cos(q1) * cos(q2) * cos(q3) * l2 - cos(q1) * cos(q2) * l1};
}

TEST(LegKinematics, AgreesWithEquation324) {
  // The report's simplified model: both links straight down at joints 0.
  RobotDimensions simplified;
  simplified.upperLeg = {0, 0, -65.27};
  simplified.lowerLegFore = {0, 0, -68.66};
  const auto shoulder = shoulderOf(simplified, Leg::foreLeft);
  Random random{1};
  for (int i = 0; i < 200; ++i) {
    const auto q = randomAngles(random, Leg::foreLeft);
    const Vector3d foot = footPosition(simplified, Leg::foreLeft, q) - shoulder;
    EXPECT_LT((foot - byReport(65.27, 68.66, q.rotator, q.elevator, q.knee)).norm(), 1e-9);
  }
}

TEST(LegKinematics, ZeroOffsetsLeadToTheReportsModel) {
  const RobotDimensions robot;
  const double l1 = std::hypot(12.8, 64.0), l2 = std::hypot(18.88, 66.0);
  const double zero1 = fromDegrees(11.31), zero3 = fromDegrees(27.27);  // facts 1.1
  Random random{2};
  for (int i = 0; i < 200; ++i) {
    auto q = randomAngles(random, Leg::foreLeft);
    q.elevator = 0;  // the offsets are about the rotator's axis only while the leg hangs upright
    const Vector3d foot = footPosition(robot, Leg::foreLeft, q) - shoulderOf(robot, Leg::foreLeft);
    const auto expected = byReport(l1, l2, q.rotator + zero1, 0, q.knee - zero3);
    EXPECT_NEAR(foot.x(), expected.x(), 0.02);
    EXPECT_NEAR(foot.y(), 0.5, 1e-9);  // the upper leg's lateral offset
    EXPECT_NEAR(foot.z(), expected.z(), 0.02);
  }
}

TEST(LegKinematics, InverseUndoesForward) {
  const RobotDimensions robot;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random{seed};
    for (int i = 0; i < 500; ++i)
      for (const auto leg : legs) {
        const auto q = randomAngles(random, leg);
        const auto foot = footPosition(robot, leg, q);
        const auto [solved, reachable] = legAngles(robot, leg, foot);
        EXPECT_TRUE(reachable);
        EXPECT_LT((footPosition(robot, leg, solved) - foot).norm(), 1e-6);
        EXPECT_NEAR(solved.rotator, q.rotator, 1e-6);
        EXPECT_NEAR(solved.elevator, q.elevator, 1e-6);
        EXPECT_NEAR(solved.knee, q.knee, 1e-5);
      }
  }
}

TEST(LegKinematics, UnreachableTargetsAreClampedToTheShell) {
  const RobotDimensions robot;
  const double longest = std::hypot(12.8, 64.0) + std::hypot(18.88, 66.0);
  Random random{4};
  for (int i = 0; i < 200; ++i) {
    const Vector3d ray =
        Vector3d{random.symmetric(), random.uniform(0.1, 1), random.uniform(-2, -1)}.normalized();
    const auto shoulder = shoulderOf(robot, Leg::foreLeft);
    const auto [q, reachable] = legAngles(robot, Leg::foreLeft, shoulder + 300 * ray);
    EXPECT_FALSE(reachable);
    const Vector3d foot = footPosition(robot, Leg::foreLeft, q) - shoulder;
    EXPECT_NEAR(foot.norm(), longest, 0.01);
    EXPECT_GT(foot.normalized().dot(ray), 0.9999);
  }
  for (const auto leg : legs)  // nothing breaks at the shoulder itself
    EXPECT_TRUE(std::isfinite(legAngles(robot, leg, shoulderOf(robot, leg)).angles.rotator));
}

TEST(LegKinematics, ElevatorsLimitFollowsTheRotator) {
  EXPECT_NEAR(toDegrees(leastElevator(Leg::foreLeft, fromDegrees(90))), -0.7, 1e-9);
  EXPECT_NEAR(toDegrees(leastElevator(Leg::hindLeft, fromDegrees(-52.5))), -7, 1e-9);
  EXPECT_NEAR(toDegrees(leastElevator(Leg::hindRight, fromDegrees(180))), 1, 1e-9);
}

}  // namespace
}  // namespace gt
