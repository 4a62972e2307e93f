#include "modules/modeling/selflocator/PoseMeasurements.h"

#include <gtest/gtest.h>

#include "base/NumericJacobian.h"

namespace gt {
namespace {

/// x, y (mm), rotation (rad) of the robot, tilt, roll and pan of its camera (rad).
using Unknowns = Eigen::Matrix<double, 6, 1>;

PoseHypothesis hypothesisOf(const Unknowns& u) {
  PoseHypothesis hypothesis{{u[2], u[0], u[1]}, 10, 0.1};
  // Tilt and roll of the lean count as the camera's, whose pan has a mean.
  hypothesis.turnCamera({{0, 0, u[5]}, {0, 0, 0}});
  hypothesis.setLean({u[3], u[4]}, Eigen::Matrix2d::Zero());
  return hypothesis;
}

/// How far the slopes of a measurement are from those of its expected value, as shares of the
/// slopes' length: by the pose, and by the camera's angles.
template <class Measure>
Eigen::Vector2d slopesOff(const Unknowns& at, const Measure& measure) {
  const Unknowns steps{0.1, 0.1, 1e-5, 1e-5, 1e-5, 1e-5};
  const auto expected = [&](const Unknowns& u) {
    return Eigen::Matrix<double, 1, 1>{-measure(hypothesisOf(u)).innovation};
  };
  const Unknowns numeric = numericJacobian(expected, at, steps).transpose();
  const ScalarMeasurement m = measure(hypothesisOf(at));
  const auto off = [](const Vector3d& slope, const Vector3d& truth) {
    return (slope - truth).norm() / std::max(truth.norm(), 1e-9);
  };
  return {off(m.slope, numeric.head<3>()), off(m.byCamera, numeric.tail<3>())};
}

const std::array poses{Pose2D{0.3, -700, 300}, Pose2D{-2, 1500, -900}, Pose2D{1.5, 200, 0}};

TEST(PoseMeasurements, SlopesOfBearingsAreDerivatives) {
  for (const Pose2D& pose : poses)
    for (const double radius : {0., 50., -50.}) {
      const Bearing bearing{{-1350, 1450}, radius, {1, 0}};
      const Unknowns at{pose.translation.x(), pose.translation.y(), pose.rotation, 0, 0, 0.02};
      const auto off = slopesOff(at, [&](const PoseHypothesis& hypothesis) {
        return measurementOf(bearing, {110, 5}, hypothesis, 1e-4, 0);
      });
      EXPECT_LT(off.maxCoeff(), 1e-6) << pose.translation.transpose() << ", radius " << radius;
    }
}

TEST(PoseMeasurements, SlopesOfDistancesAreDerivatives) {
  FlagPercept flag;
  flag.distance = 1500;
  for (const Pose2D& pose : poses) {
    const Unknowns at{pose.translation.x(), pose.translation.y(), pose.rotation, 0, 0, 0};
    const auto off = slopesOff(at, [&](const PoseHypothesis& hypothesis) {
      return measurementOf(flag, {-1350, 1450}, hypothesis.pose(), 0.05);
    });
    EXPECT_LT(off[0], 1e-6);
  }
}

TEST(PoseMeasurements, SlopesOfPointsOnEdgesAreDerivatives) {
  const EdgeTables edges{FieldDimensions{}, TeamColor::red};
  const Vector3d camera{110, 5, 190};
  for (const Pose2D& pose : poses)
    for (const EdgeType type : {EdgeType::line, EdgeType::border})
      for (const Vector2d& seen : {Vector2d{700, 200}, Vector2d{400, -300}}) {
        const Unknowns at{pose.translation.x(), pose.translation.y(), pose.rotation, 0, 0, 0};
        const auto off = slopesOff(at, [&](const PoseHypothesis& hypothesis) {
          return measurementOf({type, seen}, edges, camera, hypothesis, {8, 0.008, 0.01, 0.02});
        });
        EXPECT_LT(off.maxCoeff(), 1e-4) << pose.translation.transpose() << ", " << seen.transpose();
      }
}

}  // namespace
}  // namespace gt
