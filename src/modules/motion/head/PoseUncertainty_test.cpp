#include "modules/motion/head/PoseUncertainty.h"

#include <gtest/gtest.h>

#include <array>

namespace gt {
namespace {

const PoseUncertainty::Parameters parameters;
const Pose2D robot{0.3, -500, 200};
const Vector2d flag{2100, 1400}, other{2100, -1400};

TEST(PoseUncertainty, LooksAreWorthLessTheMoreIsKnown) {
  PoseUncertainty pose;
  const double first = pose.gain(robot, std::array{flag}, parameters);
  pose.see(robot, flag, parameters);
  const double again = pose.gain(robot, std::array{flag}, parameters);
  const double elsewhere = pose.gain(robot, std::array{other}, parameters);
  EXPECT_GT(first, again);
  EXPECT_GT(elsewhere, 1.5 * again) << "another direction says what the first left open";
  for (int i = 0; i < 500; ++i) {
    pose.see(robot, flag, parameters);
    pose.see(robot, other, parameters);
  }
  EXPECT_LT(pose.gain(robot, std::array{flag, other}, parameters), 0.1);
  EXPECT_LT(pose.position(), parameters.neededPosition);
  EXPECT_EQ(pose.gain(robot, {}, parameters), 0);
}

TEST(PoseUncertainty, PassesAsARandomWalkUpToALimit) {
  PoseUncertainty pose;
  for (int i = 0; i < 5000; ++i) {
    pose.see(robot, flag, parameters);
    pose.see(robot, other, parameters);
  }
  const double before = pose.position();
  for (int i = 0; i < 400; ++i) pose.pass(0.01, parameters);
  EXPECT_NEAR(pose.position(), std::hypot(before, 2 * parameters.walking), 1e-6);
  for (int i = 0; i < 1000; ++i) pose.pass(1, parameters);
  EXPECT_NEAR(pose.position(), 1000, 1e-6);
  EXPECT_GT(pose.gain(robot, std::array{flag}, parameters), 1);
}

/// A direction and a distance, linearized by small steps, are what a least-squares solution of the
/// same measurements would have as its covariance.
TEST(PoseUncertainty, IsThatOfLeastSquares) {
  const auto measure = [](const Pose2D& from) {
    Eigen::Vector4d z;
    int i = 0;
    for (const Vector2d& landmark : {flag, other}) {
      const Vector2d seen = relative(from, landmark);
      z[i++] = std::atan2(seen.y(), seen.x()) / parameters.bearing;
      z[i++] = seen.norm() / (parameters.distance * (landmark - robot.translation).norm());
    }
    return z;
  };
  Eigen::Matrix<double, 4, 3> slope;
  constexpr double step = 1e-4;
  for (int i = 0; i < 3; ++i) {
    Pose2D moved = robot;
    if (i < 2)
      moved.translation[i] += step;
    else
      moved.rotation += step;
    slope.col(i) = (measure(moved) - measure(robot)) / step;
  }
  Eigen::Matrix3d known = slope.transpose() * slope;
  known.diagonal() += Eigen::Vector3d{1e-6, 1e-6, 1};  // what is known at first: a meter, a rad
  const Eigen::Matrix3d covariance = known.inverse();
  PoseUncertainty pose;
  pose.see(robot, flag, parameters);
  pose.see(robot, other, parameters);
  EXPECT_NEAR(pose.position(), std::sqrt(std::max(covariance(0, 0), covariance(1, 1))), 0.1);
}

}  // namespace
}  // namespace gt
