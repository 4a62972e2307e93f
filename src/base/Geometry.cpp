#include "base/Geometry.h"

// Products of matrices are here and not in the header: each file that includes it would compile
// them anew.

namespace gt {

Matrix3d rotationX(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix();
}

Matrix3d rotationY(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
}

Matrix3d rotationZ(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

namespace {

/// Whether the rotated x-axis points straight up or down.
bool isUpright(const Matrix3d& rotation) {
  return std::hypot(rotation(2, 1), rotation(2, 2)) < 1e-9;
}

}  // namespace

double angleX(const Matrix3d& rotation) {
  return isUpright(rotation) ? 0 : std::atan2(rotation(2, 1), rotation(2, 2));
}

double angleY(const Matrix3d& rotation) {
  return std::atan2(-rotation(2, 0), std::hypot(rotation(2, 1), rotation(2, 2)));
}

double angleZ(const Matrix3d& rotation) {
  return isUpright(rotation) ? std::atan2(-rotation(0, 1), rotation(1, 1))
                             : std::atan2(rotation(1, 0), rotation(0, 0));
}

Vector3d Pose3D::operator*(const Vector3d& point) const {
  return rotation * point + translation;
}

Pose3D Pose3D::operator*(const Pose3D& other) const {
  return {rotation * other.rotation, rotation * other.translation + translation};
}

Pose3D Pose3D::inverse() const {
  return {rotation.transpose(), -(rotation.transpose() * translation)};
}

Pose3D& Pose3D::translate(const Vector3d& by) {
  translation += rotation * by;
  return *this;
}

Pose3D& Pose3D::rotate(const Matrix3d& by) {
  rotation = rotation * by;
  return *this;
}

}  // namespace gt
