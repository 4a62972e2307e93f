#pragma once
#include "base/Geometry.h"

namespace gt {

/// A scalar measurement of a Kalman filter: the innovation (measured minus expected value), the
/// derivatives of the expected value with respect to the pose (x, y, rotation) and to the errors of
/// the camera's angles, and the variance of the measurement's own error.
///
/// `usual` is the variance of all its errors, including those of the camera: the variance of the
/// innovation if the pose is exactly known. 0: `variance`.
struct ScalarMeasurement {
  double innovation;
  Vector3d slope;
  double variance;
  /// With respect to tilt, roll and pan, whether constant or swaying.
  Vector3d byCamera = Vector3d::Zero();
  double usual = 0;
};

/// A model of the errors of the camera's angles that the robot measures, as a process in time.
struct CameraErrors {
  Vector3d mean = Vector3d::Zero();       ///< Of tilt, roll and pan, rad.
  Vector3d variances = Vector3d::Zero();  ///< rad^2
  /// Share of the errors of tilt and roll that is left an image later.
  double memory = 0;
  double leanVariance = 0;  ///< Variance of the lean's tilt and roll, rad^2.
  double leanMemory = 1;    ///< Share of the lean that is left an image later.
};

/// A pose with a normally distributed error: an extended Kalman filter of x, y (mm, on the field)
/// and rotation (rad) that rejects outliers. The errors of the camera's tilt, roll and pan, which
/// all measurements of an image share, are part of the state. Errors of tilt and roll sway, so that
/// they are correlated from image to image; the error of the pan is independent in each image. The
/// lean is a constant part of the errors of tilt and roll, because the robot's body differs from
/// its model.
class PoseHypothesis {
 public:
  /// Of x, y and rotation, of the camera's tilt, roll and pan, of the lean's tilt and roll.
  using State = Eigen::Matrix<double, 8, 1>;
  using Covariance = Eigen::Matrix<double, 8, 8>;

  PoseHypothesis() = default;
  /// The standard deviations of the position (mm) and of the rotation (rad).
  PoseHypothesis(const Pose2D& pose, double standardDeviation, double angleStandardDeviation);

  /// Moves by the odometry's step. `noise` is the variance that the step adds, in the robot's
  /// system (mm^2, mm^2, rad^2).
  void move(const Pose2D& step, const Vector3d& noise);
  /// Predicts the errors of the camera in the next image.
  void turnCamera(const CameraErrors& errors);
  /// Corrects the state by a measurement unless its innovation exceeds `gate` standard deviations.
  /// Returns its likelihood, in [0, 1], relative to a measurement that fits exactly to an exactly
  /// known pose.
  double correct(const ScalarMeasurement& measurement, double gate);
  /// Returns whether another pose lies within a distance (mm) and an angle (rad).
  bool isNear(const Pose2D& other, double distance, double angle) const;
  /// Limits the position to +-farX and +-farY (mm, on the field).
  void clamp(double farX, double farY);
  /// Rotates the pose by half a turn around the middle of the field.
  void mirror();
  /// Sets the lean (rad) and its covariance, as known before the first measurement.
  void setLean(const Vector2d& lean, const Eigen::Matrix2d& covariance);

  const Pose2D& pose() const { return pose_; }
  /// The estimated errors of the camera's tilt, roll and pan, rad.
  const Vector3d& camera() const { return camera_; }
  /// The estimated constant part of the errors of tilt and roll, rad.
  const Vector2d& lean() const { return lean_; }
  Eigen::Matrix2d leanCovariance() const { return covariance_.bottomRightCorner<2, 2>(); }
  /// The covariance of the state, mm^2 and rad^2.
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
