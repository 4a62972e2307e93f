#include "modules/modeling/selflocator/PoseHypothesis.h"

#include <algorithm>
#include <cmath>

namespace gt {

PoseHypothesis::PoseHypothesis(const Pose2D& pose, double standardDeviation,
                               double angleStandardDeviation)
    : pose_{pose}, covariance_{Covariance::Zero()} {
  covariance_(0, 0) = covariance_(1, 1) = standardDeviation * standardDeviation;
  covariance_(2, 2) = angleStandardDeviation * angleStandardDeviation;
}

void PoseHypothesis::move(const Pose2D& step, const Vector3d& noise) {
  const Vector2d way = rotated(step.translation, pose_.rotation);
  Matrix3d jacobian = Matrix3d::Identity();
  jacobian(0, 2) = -way.y();
  jacobian(1, 2) = way.x();
  const Matrix3d turn = rotationZ(pose_.rotation);
  covariance_.topRows<3>() = (jacobian * covariance_.topRows<3>()).eval();
  covariance_.leftCols<3>() = (covariance_.leftCols<3>() * jacobian.transpose()).eval();
  covariance_.topLeftCorner<3, 3>() += turn * noise.asDiagonal() * turn.transpose();
  pose_ = pose_ * step;
}

void PoseHypothesis::turnCamera(const CameraErrors& errors) {
  const Vector3d kept{errors.memory, errors.memory, 0};
  camera_ = errors.mean + kept.cwiseProduct(camera_ - errors.mean);
  for (int i = 0; i < 3; ++i) {
    covariance_.row(3 + i) *= kept[i];
    covariance_.col(3 + i) *= kept[i];
    covariance_(3 + i, 3 + i) += (1 - kept[i] * kept[i]) * errors.variances[i];
  }
  const double left = errors.leanMemory;
  lean_ *= left;
  covariance_.bottomRows<2>() *= left;
  covariance_.rightCols<2>() *= left;
  covariance_.diagonal().tail<2>().array() += (1 - left * left) * errors.leanVariance;
}

double PoseHypothesis::correct(const ScalarMeasurement& m, double gate) {
  State slope;
  slope << m.slope, m.byCamera, m.byCamera.head<2>();
  const State spread = covariance_ * slope;
  const double variance = slope.dot(spread) + m.variance;
  const double squared = m.innovation * m.innovation / variance;
  const double usual = std::max(m.usual, m.variance);
  const double likelihood = std::sqrt(std::min(usual / variance, 1.0)) * std::exp(-squared / 2);
  if (!std::isfinite(squared)) return 0;
  if (squared > gate * gate) return likelihood;
  const State gain = spread / variance;
  pose_.translation += (gain * m.innovation).head<2>();
  pose_.rotate(gain[2] * m.innovation);
  camera_ += gain.segment<3>(3) * m.innovation;
  lean_ += gain.tail<2>() * m.innovation;
  covariance_ -= gain * spread.transpose();
  return likelihood;
}

bool PoseHypothesis::isNear(const Pose2D& other, double distance, double angle) const {
  return (pose_.translation - other.translation).squaredNorm() < distance * distance &&
         std::abs(normalize(pose_.rotation - other.rotation)) < angle;
}

void PoseHypothesis::clamp(double farX, double farY) {
  pose_.translation.x() = std::clamp(pose_.translation.x(), -farX, farX);
  pose_.translation.y() = std::clamp(pose_.translation.y(), -farY, farY);
}

void PoseHypothesis::mirror() {
  pose_ = Pose2D{pi, 0, 0} * pose_;
  covariance_.topRightCorner<2, 6>() *= -1;
  covariance_.bottomLeftCorner<6, 2>() *= -1;
}

void PoseHypothesis::setLean(const Vector2d& lean, const Eigen::Matrix2d& covariance) {
  lean_ = lean;
  covariance_.bottomRows<2>().setZero();
  covariance_.rightCols<2>().setZero();
  covariance_.bottomRightCorner<2, 2>() = covariance;
}

}  // namespace gt
