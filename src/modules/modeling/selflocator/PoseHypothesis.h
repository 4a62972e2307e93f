#pragma once
#include "base/Geometry.h"

namespace gt {

/// One measured number as a Kalman filter sees it: how far it lies beside what is expected, how
/// that depends on the pose (x, y, rotation), and the variance of its error.
struct ScalarMeasurement {
  double innovation;
  Vector3d slope;
  double variance;
};

/// A pose that is known with a normally distributed error: an extended Kalman filter of x, y and
/// rotation, that believes no measurement that is too far off.
class PoseHypothesis {
 public:
  PoseHypothesis() = default;
  /// The standard deviations in mm and rad.
  PoseHypothesis(const Pose2D& pose, double standardDeviation, double angleStandardDeviation);

  /// Moves by the odometry's step; the noise is the variance of the error that grows meanwhile, in
  /// the robot's system (mm^2, mm^2, rad^2).
  void move(const Pose2D& step, const Vector3d& noise);
  /// Takes a measurement in if it is not farther off than so many standard deviations. Returns how
  /// likely it was, against one that fits exactly to a pose that is exactly known; in [0, 1].
  double correct(const ScalarMeasurement& measurement, double gate);
  /// Whether another pose lies so near that it is the same.
  bool isNear(const Pose2D& other, double distance, double angle) const;
  void clamp(double farX, double farY);
  /// Turns it by half a circle around the middle of the field.
  void mirror();

  const Pose2D& pose() const { return pose_; }
  /// mm^2, rad^2.
  const Matrix3d& covariance() const { return covariance_; }
  /// The standard deviation of the position, mm.
  double standardDeviation() const { return std::sqrt(covariance_(0, 0) + covariance_(1, 1)); }

 private:
  Pose2D pose_;
  Matrix3d covariance_ = Matrix3d::Identity();
};

}  // namespace gt
