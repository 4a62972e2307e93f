#include "modules/perception/specialists/TiltCorrection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/Random.h"

namespace gt {
namespace {

/// Landmarks as a robot sees them that believes its camera to be level.
class Seen : public testing::Test {
 protected:
  FieldDimensions field_;
  CameraMatrix matrix_;
  BallPercept ball_;
  LandmarksPercept landmarks_;
  TiltCorrection correction_;
  Random random_{1};
  double tilt_ = 0, roll_ = 0;  ///< rad, of the true camera.
  double noise_ = 0;            ///< rad, of each edge.

  void SetUp() override { matrix_.pose.translation = {90, 0, 190}; }

  /// The angles to a point in the robot's system, as they are taken with the wrong matrix.
  Vector2d anglesTo(const Vector3d& point) {
    const Vector3d ray =
        (rotationY(-tilt_) * rotationX(roll_)).transpose() * (point - matrix_.pose.translation);
    return {std::atan2(ray.y(), ray.x()) + noise_ * random_.gaussian(),
            std::atan2(ray.z(), ray.head<2>().norm()) + noise_ * random_.gaussian()};
  }
  ConditionalBoundary boundaryOf(const Vector2d& place, double half, double low, double high) {
    const auto at = [&](double side, double z) {
      return anglesTo({place.x(), place.y() + side * half, z});
    };
    return {.left = at(1, low).x(),
            .right = at(-1, low).x(),
            .top = at(0, high).y(),
            .bottom = at(0, low).y()};
  }
  void seeFlag(const Vector2d& place) {
    auto& flag = landmarks_.flags[static_cast<std::size_t>(landmarks_.numberOfFlags++)];
    flag.boundary = boundaryOf(place, field_.flagRadius, field_.flagBottom, field_.flagTop);
  }
  void seeGoal(const Vector2d& middle) {
    auto& goal = landmarks_.goals[static_cast<std::size_t>(landmarks_.numberOfGoals++)];
    goal.boundary = boundaryOf(middle, field_.yGoal, 0, field_.goalHeight);
  }
  void seeBall(const Vector2d& place) {
    const Vector3d at{place.x(), place.y(), field_.ballRadius};
    const double lower = matrix_.pose.translation.z() - field_.ballRadius;
    ball_.seen = true;
    ball_.angle = anglesTo(at);
    ball_.distanceBySize = (at - matrix_.pose.translation).norm();
    ball_.distanceByProjection = lower / std::sin(-ball_.angle.y());
    ball_.centerInImage = {88, 72};
    ball_.radiusInImage = field_.ballRadius / ball_.distanceBySize * matrix_.info.focalX;
  }
  /// The elevation at which the corrected camera sees what the true one sees on the horizon.
  double errorAt(double azimuth) {
    const CameraMatrix& corrected = correction_.correct(matrix_, ball_, landmarks_, field_);
    const Vector3d ray = (rotationY(-tilt_) * rotationX(roll_)).transpose() *
                         Vector3d{std::cos(azimuth), std::sin(azimuth), 0};
    return toDegrees(std::asin((corrected.pose.rotation * ray).z()));
  }
};

TEST_F(Seen, EachLandmarkTellsTheTilt) {
  for (const double tilt : {-1.5, 1.5}) {
    tilt_ = fromDegrees(tilt);
    for (int thing = -1; thing < 3; ++thing) {
      correction_ = {};
      ball_ = {};
      landmarks_ = {};
      if (thing == 0) seeFlag({1500, 0});
      if (thing == 1) seeGoal({1800, 0});
      if (thing == 2) seeBall({700, 0});
      EXPECT_NEAR(std::abs(errorAt(0)), thing < 0 ? 1.5 : 0, 0.6) << tilt << " degrees, " << thing;
    }
  }
}

TEST_F(Seen, TwoLandmarksTellTheRoll) {
  roll_ = fromDegrees(2);
  seeFlag({1000, 1000});
  seeFlag({1000, -1000});
  EXPECT_NEAR(errorAt(pi / 4), 0, 0.3);
  EXPECT_NEAR(errorAt(-pi / 4), 0, 0.3);
}

TEST_F(Seen, WhatIsFarOffIsSomethingElse) {
  tilt_ = fromDegrees(8);
  seeFlag({1500, 0});
  EXPECT_NEAR(std::abs(errorAt(0)), 8, 0.01);
}

// With the matrices of a body that does not sway the noise of landmarks would do harm.
TEST_F(Seen, CamerasThatDoNotErrAreLeftAlone) {
  matrix_.covariance *= 0.001;
  noise_ = 0.004;
  double sum = 0;
  for (int i = 0; i < 100; ++i) {
    landmarks_.numberOfFlags = 0;
    seeFlag({1500, 0});
    sum += std::abs(errorAt(0));
  }
  EXPECT_LT(sum / 100, 0.06);
}

TEST_F(Seen, TellsHowMuchOfTheErrorIsLeft) {
  seeFlag({1500, 0});
  const CameraMatrix& corrected = correction_.correct(matrix_, ball_, landmarks_, field_);
  EXPECT_LT(corrected.elevationVariance(0), 0.1 * matrix_.elevationVariance(0));
  EXPECT_NEAR(corrected.elevationVariance(pi / 2), matrix_.elevationVariance(pi / 2), 1e-6)
      << "a flag ahead tells no roll";
}

}  // namespace
}  // namespace gt
