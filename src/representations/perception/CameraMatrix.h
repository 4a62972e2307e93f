#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/CameraInfo.h"

namespace gt {

/// The pose of the camera relative to the robot's origin on the ground when the image was taken
/// (report 3.1). Rows are exposed one after another while the head turns: each row has a rotation
/// of its own. Provided by the SensorDataProcessor.
struct CameraMatrix {
  Time time;
  Pose3D pose;
  Vector3d turning = Vector3d::Zero();
  CameraInfo info;
  bool valid = false;
  Matrix3d covariance = usualCovariance();

  /// Default covariance of a walking robot, for which no better estimate is known.
  static Matrix3d usualCovariance() {
    constexpr double angle = fromDegrees(1.2), height = 4;  // mm
    return Vector3d{angle * angle, angle * angle, height * height}.asDiagonal();
  }

  /// The camera's rotation when a row was exposed. Row 0 is exposed (height - 1) * rowTime before
  /// the image's time.
  Matrix3d rotationAt(double row) const {
    const double seconds = (row - info.height / 2.0) * info.rowTime / 1000;
    const Vector3d angle = turning * seconds;
    Matrix3d skew;
    skew << 1, -angle.z(), angle.y(), angle.z(), 1, -angle.x(), -angle.y(), angle.x(), 1;
    return skew * pose.rotation;
  }

  /// The direction from the camera to a point of the image (pixels), in the robot's system; not
  /// normalized.
  Vector3d ray(double x, double y) const { return rotationAt(y) * info.ray(x, y); }

  /// The variance (rad^2) of the elevation of a point that is seen in a direction (rad) in the
  /// robot's system.
  double elevationVariance(double azimuth) const {
    const Vector2d lowers{-std::sin(azimuth), std::cos(azimuth)};
    return lowers.dot(covariance.topLeftCorner<2, 2>() * lowers);
  }

  static constexpr auto fields() {
    return Fields{
        field<&CameraMatrix::time>(Unit::ms, "time of the image"),
        field<&CameraMatrix::pose>(
            Unit::mm,
            "pose relative to the robot's origin on the ground, when the middle row was exposed"),
        field<&CameraMatrix::turning>(Unit::radPerS,
                                      "angular velocity of the camera, relative to the robot"),
        field<&CameraMatrix::info>(),
        field<&CameraMatrix::valid>("false during kicks and falls"),
        field<&CameraMatrix::covariance>(
            "covariance of the errors of the rotation about the robot's x and y axis (rad) and of "
            "the height (mm)")};
  }
};

}  // namespace gt
