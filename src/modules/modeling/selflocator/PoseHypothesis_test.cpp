#include "modules/modeling/selflocator/PoseHypothesis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/NumericJacobian.h"

namespace gt {
namespace {

/// What the linear filter knows in closed form: two measurements of one coordinate.
TEST(PoseHypothesis, WeighsByVariances) {
  PoseHypothesis hypothesis{{0, 0, 0}, 20, 0.1};
  const auto measure = [&](double x, double standardDeviation) {
    return hypothesis.correct(
        {x - hypothesis.pose().translation.x(), {1, 0, 0}, standardDeviation * standardDeviation},
        3);
  };
  const double likelihood = measure(30, 20);
  EXPECT_NEAR(hypothesis.pose().translation.x(), 15, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(0, 0), 200, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(1, 1), 400, 1e-9);
  EXPECT_NEAR(likelihood, std::sqrt(0.5) * std::exp(-900 / 800. / 2), 1e-9);
  measure(-500, 20);  // no one believes that
  EXPECT_NEAR(hypothesis.pose().translation.x(), 15, 1e-9);
}

TEST(PoseHypothesis, WhatIsNoNumberIsNotBelieved) {
  PoseHypothesis hypothesis{{0, 0, 0}, 20, 0.1};
  EXPECT_EQ(hypothesis.correct({std::nan(""), {1, 0, 0}, 400}, 3), 0);
  EXPECT_EQ(hypothesis.pose().translation, (Vector2d{0, 0}));
}

TEST(PoseHypothesis, AnUnknownRotationMakesAWalkUncertainSideways) {
  PoseHypothesis hypothesis{{pi / 2, 0, 0}, 10, 0.1};
  hypothesis.move({0, 1000, 0}, {0, 0, 0});
  EXPECT_NEAR(hypothesis.pose().translation.y(), 1000, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(0, 0), 100 + 10000, 1e-6);
  EXPECT_NEAR(hypothesis.covariance()(1, 1), 100, 1e-6);
}

TEST(PoseHypothesis, AStepMovesTheCovarianceByItsDerivative) {
  const Pose2D step{-0.3, 40, 25};
  const auto moved = [&](const Vector3d& p) {
    const Pose2D pose = Pose2D{p.z(), p.x(), p.y()} * step;
    return Vector3d{pose.translation.x(), pose.translation.y(), pose.rotation};
  };
  const Matrix3d derivative =
      numericJacobian(moved, Vector3d{300, -200, 0.8}, Vector3d{0.1, 0.1, 1e-4});
  PoseHypothesis hypothesis{{0.8, 300, -200}, 20, 0.1};
  const Matrix3d before = hypothesis.covariance().topLeftCorner<3, 3>();
  hypothesis.move(step, Vector3d::Zero());
  const Matrix3d expected = derivative * before * derivative.transpose();
  EXPECT_LT((hypothesis.covariance().topLeftCorner<3, 3>() - expected).norm(), 1e-6);
}

TEST(PoseHypothesis, RotationsAreCorrectedAcrossTheSeam) {
  PoseHypothesis hypothesis{{pi - 0.01, 0, 0}, 10, 0.1};
  hypothesis.correct({0.04, {0, 0, 1}, 0.01}, 3);
  EXPECT_NEAR(hypothesis.pose().rotation, -pi + 0.01, 1e-9);
}

/// Measurements that share an error do not make the pose better known than that error allows.
TEST(PoseHypothesis, ErrorsOfTheCameraDoNotAverageOut) {
  PoseHypothesis hypothesis{{0, 0, 0}, 0, 1};
  hypothesis.turnCamera({{0, 0, 0}, {0, 0, 0.04}, 0});
  for (int i = 0; i < 100; ++i) hypothesis.correct({0.1, {0, 0, 1}, 1e-4, {0, 0, 1}}, 100);
  EXPECT_NEAR(hypothesis.covariance()(2, 2), 1 * 0.04 / 1.04, 1e-4);
  // The next image's pan errs otherwise, so that the mean of many images is known better.
  for (int i = 0; i < 100; ++i) {
    hypothesis.turnCamera({{0, 0, 0}, {0, 0, 0.04}, 0});
    hypothesis.correct({0, {0, 0, 1}, 1e-4, {0, 0, 1}}, 100);
  }
  EXPECT_LT(hypothesis.covariance()(2, 2), 0.001);
}

/// Tilt and roll stay what they are as far as they are remembered; the pan starts at its mean.
TEST(PoseHypothesis, TheCameraSways) {
  PoseHypothesis hypothesis{{0, 0, 0}, 10, 0.1};
  const CameraErrors errors{{0, 0, 0.2}, {0.04, 0.01, 0.09}, 0.5};
  hypothesis.turnCamera(errors);
  EXPECT_NEAR(hypothesis.camera().z(), 0.2, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(3, 3), 0.75 * 0.04, 1e-9);
  EXPECT_NEAR(hypothesis.covariance()(5, 5), 0.09, 1e-9);
  hypothesis.correct({0.1, {0, 0, 0}, 1e-9, {1, 0, 0}}, 100);
  hypothesis.correct({0.1, {0, 0, 0}, 1e-9, {0, 0, 1}}, 100);
  EXPECT_NEAR(hypothesis.camera().x(), 0.1, 1e-6);
  EXPECT_NEAR(hypothesis.camera().z(), 0.3, 1e-6);
  hypothesis.turnCamera(errors);
  EXPECT_NEAR(hypothesis.camera().x(), 0.05, 1e-6);
  EXPECT_NEAR(hypothesis.camera().z(), 0.2, 1e-9);
  EXPECT_EQ(hypothesis.pose().translation, (Vector2d{0, 0}));
}

/// What stays off while the camera sways is the lean: it is known ever better.
TEST(PoseHypothesis, LearnsTheLean) {
  PoseHypothesis hypothesis{{0, 0, 0}, 10, 0.1};
  hypothesis.setLean({0, 0}, 0.0004 * Eigen::Matrix2d::Identity());
  const CameraErrors errors{{0, 0, 0}, {0.0004, 0.0004, 0.0004}, 0.5, 0.0004, 0.9999};
  for (int i = 0; i < 400; ++i) {
    hypothesis.turnCamera(errors);
    const double sway = i % 2 == 0 ? 0.02 : -0.02;
    const double known = hypothesis.camera().x() + hypothesis.lean().x();
    hypothesis.correct({0.03 + sway - known, {0, 0, 0}, 1e-6, {1, 0, 0}}, 100);
  }
  EXPECT_NEAR(hypothesis.lean().x(), 0.03, 0.005);
  EXPECT_NEAR(hypothesis.lean().y(), 0, 1e-9);
  EXPECT_LT(hypothesis.leanCovariance()(0, 0), 0.2 * 0.0004);
  EXPECT_GT(hypothesis.leanCovariance()(1, 1), 0.9 * 0.0004);
}

/// What is usually off is no reason to disbelieve a pose.
TEST(PoseHypothesis, JudgesByTheUsualError) {
  PoseHypothesis hypothesis{{0, 0, 0}, 0, 0.1};
  hypothesis.turnCamera({{0, 0, 0}, {0, 0, 0.03}, 0});
  EXPECT_NEAR(hypothesis.correct({0, {0, 0, 1}, 0.01, {0, 0, 1}, 0.04}, 3), std::sqrt(0.8), 1e-9);
}

TEST(PoseHypothesis, IsItselfWhenMirroredTwice) {
  PoseHypothesis hypothesis{{1, 700, -300}, 10, 0.1};
  hypothesis.move({0.2, 500, 100}, {1, 2, 0.01});
  hypothesis.turnCamera({{0, 0, 0}, {0, 0, 0.01}, 0});
  hypothesis.correct({10, {1, 0, 0.5}, 100, {0, 0, 1}}, 100);
  PoseHypothesis mirrored = hypothesis;
  mirrored.mirror();
  EXPECT_NEAR((mirrored.pose().translation + hypothesis.pose().translation).norm(), 0, 1e-9);
  EXPECT_NEAR(mirrored.covariance()(0, 1), hypothesis.covariance()(0, 1), 1e-9);
  EXPECT_NEAR(mirrored.covariance()(0, 2), -hypothesis.covariance()(0, 2), 1e-9);
  EXPECT_NE(hypothesis.covariance()(0, 5), 0);
  EXPECT_NEAR(mirrored.covariance()(0, 5), -hypothesis.covariance()(0, 5), 1e-9);
  EXPECT_NEAR(mirrored.covariance()(5, 1), -hypothesis.covariance()(5, 1), 1e-9);
  mirrored.mirror();
  EXPECT_TRUE(mirrored.isNear(hypothesis.pose(), 1e-6, 1e-9));
}

}  // namespace
}  // namespace gt
