#include "modules/modeling/selflocator/PoseHypothesis.h"

#include <algorithm>
#include <cmath>

namespace gt {

PoseHypothesis::PoseHypothesis(const Pose2D& pose, double standardDeviation,
                               double angleStandardDeviation)
    : pose_{pose},
      covariance_{Vector3d{standardDeviation * standardDeviation,
                           standardDeviation * standardDeviation,
                           angleStandardDeviation * angleStandardDeviation}
                      .asDiagonal()} {}

void PoseHypothesis::move(const Pose2D& step, const Vector3d& noise) {
  const Vector2d way = rotated(step.translation, pose_.rotation);
  Matrix3d jacobian = Matrix3d::Identity();
  jacobian(0, 2) = -way.y();
  jacobian(1, 2) = way.x();
  const Matrix3d turn = rotationZ(pose_.rotation);
  covariance_ =
      jacobian * covariance_ * jacobian.transpose() + turn * noise.asDiagonal() * turn.transpose();
  pose_ = pose_ * step;
}

double PoseHypothesis::correct(const ScalarMeasurement& m, double gate) {
  const Vector3d spread = covariance_ * m.slope;
  const double variance = m.slope.dot(spread) + m.variance;
  const double squared = m.innovation * m.innovation / variance;
  const double likelihood = std::sqrt(m.variance / variance) * std::exp(-squared / 2);
  if (!std::isfinite(squared)) return 0;
  if (squared > gate * gate) return likelihood;
  const Vector3d gain = spread / variance;
  pose_.translation += (gain * m.innovation).head<2>();
  pose_.rotate(gain.z() * m.innovation);
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
  covariance_.block<2, 1>(0, 2) *= -1;
  covariance_.block<1, 2>(2, 0) *= -1;
}

}  // namespace gt
