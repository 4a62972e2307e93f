#include "modules/motion/head/PoseUncertainty.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// The information matrix of the pose from direction and distance of a landmark.
Eigen::Matrix3d information(const Pose2D& robot, const Vector2d& landmark,
                            const PoseUncertainty::Parameters& p) {
  constexpr double nearest = 200;  // mm
  const Vector2d to = landmark - robot.translation;
  const double distance = std::max(to.norm(), nearest);
  const Vector2d along = to / distance;
  const Eigen::Vector3d bearing{along.y() / distance, -along.x() / distance, -1};
  const Eigen::Vector3d range{-along.x(), -along.y(), 0};
  const double spread = p.distance * distance;
  return bearing * bearing.transpose() / (p.bearing * p.bearing) +
         range * range.transpose() / (spread * spread);
}

Eigen::Matrix3d needed(const PoseUncertainty::Parameters& p) {
  return Eigen::Vector3d{p.neededPosition * p.neededPosition, p.neededPosition * p.neededPosition,
                         p.neededRotation * p.neededRotation}
      .asDiagonal();
}

}  // namespace

void PoseUncertainty::pass(double seconds, const Parameters& p) {
  const Eigen::Vector3d growth{p.walking * p.walking, p.walking * p.walking, p.turning * p.turning};
  covariance_ += seconds * Eigen::Matrix3d{growth.asDiagonal()};
  // Who knows nothing does not know less after a while.
  const Eigen::Vector3d most{lostPosition, lostPosition, lostRotation};
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  for (int i = 0; i < 3; ++i) scale[i] = std::min(1., most[i] / std::sqrt(covariance_(i, i)));
  covariance_ = scale.asDiagonal() * covariance_ * scale.asDiagonal();
}

void PoseUncertainty::see(const Pose2D& robot, const Vector2d& landmark, const Parameters& p) {
  covariance_ = Eigen::Matrix3d{covariance_.inverse() + information(robot, landmark, p)}.inverse();
}

double PoseUncertainty::gain(const Pose2D& robot, std::span<const Vector2d> landmarks,
                             const Parameters& p) const {
  if (landmarks.empty()) return 0;
  Eigen::Matrix3d known = covariance_.inverse();
  for (const Vector2d& landmark : landmarks) known += information(robot, landmark, p);
  const Eigen::Matrix3d before = covariance_ + needed(p), after = known.inverse() + needed(p);
  return 0.5 * std::log(before.determinant() / after.determinant());
}

double PoseUncertainty::position() const {
  return std::sqrt(std::max(covariance_(0, 0), covariance_(1, 1)));
}

}  // namespace gt
