#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gt {

/// Vectors and matrices of the report (2.1.4). Eigen has the operations: `a.dot(b)` is the inner
/// product, `a.cross(b)` the report's `a ^ b`, and there are `norm()`, `transpose()`,
/// `normalized()`, sums and products.
template <typename T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Matrix3x3 = Eigen::Matrix<T, 3, 3>;
using Vector2d = Vector2<double>;
using Vector3d = Vector3<double>;
using Matrix3d = Matrix3x3<double>;

constexpr double pi = std::numbers::pi;

constexpr double fromDegrees(double degrees) {
  return degrees * (pi / 180);
}
constexpr double toDegrees(double radians) {
  return radians * (180 / pi);
}

/// Normalizes an angle (rad) to [-pi, pi). Not a number if the angle is infinite or not a number.
inline double normalize(double angle) {
  if (angle >= -pi && angle < pi) return angle;
  angle = std::remainder(angle, 2 * pi);
  return angle >= pi ? -pi : angle;
}

/// Angle (rad) of a vector to the x-axis in (-pi, pi].
inline double angleOf(const Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

/// Rotates a vector counterclockwise by an angle (rad).
inline Vector2d rotated(const Vector2d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// Unit vector in the direction of an angle (rad).
inline Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Rotations about one axis by an angle (rad), counterclockwise when looking against the axis
/// (report 2.1.4, RotationMatrix). A product combines rotations, `transpose()` inverts one.
Matrix3d rotationX(double angle);
Matrix3d rotationY(double angle);
Matrix3d rotationZ(double angle);

/// Angles (rad) about the axes of a matrix that is rotationZ(z) * rotationY(y) * rotationX(x)
/// (report 2.1.4, RotationMatrix); y lies in [-pi/2, pi/2]. If y is one of these two limits, only x
/// and z together are determined, and x is 0.
double angleX(const Matrix3d& rotation);
double angleY(const Matrix3d& rotation);
double angleZ(const Matrix3d& rotation);

/// A pose on the ground (mm, rad), or a change of one: first the translation, then the rotation
/// (report 2.1.4). Functions that compute a pose normalize its rotation. The constructors do not,
/// because speeds are also stored as poses (mm/s, rad/s).
struct Pose2D {
  double rotation = 0;
  Vector2d translation = Vector2d::Zero();

  Pose2D() = default;
  Pose2D(double angle, const Vector2d& position) : rotation(angle), translation(position) {}
  Pose2D(double angle, double x, double y) : Pose2D(angle, Vector2d{x, y}) {}

  /// Transforms a point from the frame of this pose to the frame in which the pose is given.
  Vector2d operator*(const Vector2d& point) const { return translation + rotated(point, rotation); }
  /// Transforms a pose from the frame of this pose to the frame in which this pose is given.
  Pose2D operator*(const Pose2D& other) const {
    return {normalize(rotation + other.rotation), *this * other.translation};
  }
  Pose2D inverse() const { return {normalize(-rotation), rotated(-translation, -rotation)}; }
  /// This pose relative to another one: `base * relativeTo(base) == *this`.
  Pose2D relativeTo(const Pose2D& base) const { return base.inverse() * *this; }

  /// Moves the pose along its own axes.
  Pose2D& translate(const Vector2d& by) {
    translation += rotated(by, rotation);
    return *this;
  }
  Pose2D& rotate(double angle) {
    rotation = normalize(rotation + angle);
    return *this;
  }
};

/// Transforms a point on the field (mm) to the frame of a pose on the field.
inline Vector2d relative(const Pose2D& pose, const Vector2d& onField) {
  return rotated(onField - pose.translation, -pose.rotation);
}

/// A pose in space (translation in mm), or a change of one (report 2.1.4).
struct Pose3D {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d translation = Vector3d::Zero();

  Vector3d operator*(const Vector3d& point) const;
  Pose3D operator*(const Pose3D& other) const;
  Pose3D inverse() const;

  /// Moves the pose along its own axes.
  Pose3D& translate(const Vector3d& by);
  Pose3D& translate(double x, double y, double z) { return translate(Vector3d{x, y, z}); }
  Pose3D& rotate(const Matrix3d& by);
};

}  // namespace gt
