#pragma once
#include "base/Geometry.h"

namespace gt {

/// One measured number as a Kalman filter sees it: how far it lies beside what is expected, how
/// what is expected depends on the pose (x, y, rotation) and on the errors of the camera's angles,
/// and the variance of its own error.
///
/// `usual` is the variance of all its errors, those of the camera included: what a measurement is
/// expected to be off by if the pose is exactly known. 0: `variance`.
struct ScalarMeasurement {
  double innovation;
  Vector3d slope;
  double variance;
  Vector3d byCamera = Vector3d::Zero();  ///< By tilt, roll and pan, however long they are off.
  double usual = 0;
};

/// By how much the camera's angles are off that the robot states, as a process in time.
struct CameraErrors {
  Vector3d mean = Vector3d::Zero();       ///< Of tilt, roll and pan, rad.
  Vector3d variances = Vector3d::Zero();  ///< rad^2
  double memory = 0;                      ///< Share of tilt and roll that is left an image later.
  double leanVariance = 0;                ///< Of the lean's tilt and roll, rad^2.
  double leanMemory = 1;                  ///< Share of the lean that is left an image later.
};

/// A pose that is known with a normally distributed error: an extended Kalman filter of x, y and
/// rotation, that believes no measurement that is too far off. Tilt, roll and pan of the camera are
/// off, too: what all measurements of an image share is part of the state. Tilt and roll sway, so
/// that they are alike from image to image; the pan's error is another one in each. Besides, the
/// body leans: a part of tilt and roll that stays, because the robot is not built as it believes.
class PoseHypothesis {
 public:
  /// Of x, y and rotation, of the camera's tilt, roll and pan, of the lean's tilt and roll.
  using State = Eigen::Matrix<double, 8, 1>;
  using Covariance = Eigen::Matrix<double, 8, 8>;

  PoseHypothesis() = default;
  /// The standard deviations in mm and rad.
  PoseHypothesis(const Pose2D& pose, double standardDeviation, double angleStandardDeviation);

  /// Moves by the odometry's step; the noise is the variance of the error that grows meanwhile, in
  /// the robot's system (mm^2, mm^2, rad^2).
  void move(const Pose2D& step, const Vector3d& noise);
  /// The next image was taken: its camera errs otherwise.
  void turnCamera(const CameraErrors& errors);
  /// Takes a measurement in if it is not farther off than so many standard deviations. Returns how
  /// likely it was, against one that fits exactly to a pose that is exactly known; in [0, 1].
  double correct(const ScalarMeasurement& measurement, double gate);
  /// Whether another pose lies so near that it is the same.
  bool isNear(const Pose2D& other, double distance, double angle) const;
  void clamp(double farX, double farY);
  /// Turns it by half a circle around the middle of the field.
  void mirror();
  /// What is known of the lean before anything is seen from here.
  void setLean(const Vector2d& lean, const Eigen::Matrix2d& covariance);

  const Pose2D& pose() const { return pose_; }
  /// By how much the camera's tilt, roll and pan are off, rad.
  const Vector3d& camera() const { return camera_; }
  /// By how much tilt and roll are off for long, rad.
  const Vector2d& lean() const { return lean_; }
  Eigen::Matrix2d leanCovariance() const { return covariance_.bottomRightCorner<2, 2>(); }
  /// mm^2, rad^2: of the state.
  const Covariance& covariance() const { return covariance_; }
  /// The standard deviation of the position, mm.
  double standardDeviation() const { return std::sqrt(covariance_(0, 0) + covariance_(1, 1)); }

 private:
  Pose2D pose_;
  Vector3d camera_ = Vector3d::Zero();
  Vector2d lean_ = Vector2d::Zero();
  Covariance covariance_ = Covariance::Identity();
};

}  // namespace gt
