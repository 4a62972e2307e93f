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

/// The same angle in [-pi, pi); not a number if the angle is none.
inline double normalize(double angle) {
  if (angle >= -pi && angle < pi) return angle;
  angle = std::remainder(angle, 2 * pi);
  return angle >= pi ? -pi : angle;
}

/// The angle of a vector to the x-axis in (-pi, pi].
inline double angleOf(const Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

/// The vector turned counterclockwise by an angle.
inline Vector2d rotated(const Vector2d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// A unit vector to a direction.
inline Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Rotations about one axis, counterclockwise when looked at against the axis (report 2.1.4,
/// RotationMatrix): a product rotates on, `transpose()` rotates back.
Matrix3d rotationX(double angle);
Matrix3d rotationY(double angle);
Matrix3d rotationZ(double angle);

/// The rotation about an axis in a matrix that is rotationZ(z) * rotationY(y) * rotationX(x)
/// (report 2.1.4, RotationMatrix); y lies in [-pi/2, pi/2]. Where y is one of these ends only x and
/// z together are known: then x is 0.
double angleX(const Matrix3d& rotation);
double angleY(const Matrix3d& rotation);
double angleZ(const Matrix3d& rotation);

/// A pose on the ground, or a change of one: first the translation, then the rotation
/// (report 2.1.4). Whatever computes a pose normalizes its rotation; the constructors take it as it
/// is, since speeds are poses, too (rad/s and mm/s).
struct Pose2D {
  double rotation = 0;
  Vector2d translation = Vector2d::Zero();

  Pose2D() = default;
  Pose2D(double angle, const Vector2d& position) : rotation(angle), translation(position) {}
  Pose2D(double angle, double x, double y) : Pose2D(angle, Vector2d{x, y}) {}

  /// A point given relative to this pose, in the system in which the pose is given.
  Vector2d operator*(const Vector2d& point) const { return translation + rotated(point, rotation); }
  /// A pose given relative to this one, in the system in which this one is given.
  Pose2D operator*(const Pose2D& other) const {
    return {normalize(rotation + other.rotation), *this * other.translation};
  }
  Pose2D inverse() const { return {normalize(-rotation), rotated(-translation, -rotation)}; }
  /// This pose as seen from another: `base * relativeTo(base) == *this`.
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

/// Where a point given in the field's system is, seen from a pose.
inline Vector2d relative(const Pose2D& pose, const Vector2d& onField) {
  return rotated(onField - pose.translation, -pose.rotation);
}

/// A pose in space, or a change of one (report 2.1.4).
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
