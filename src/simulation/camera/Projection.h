#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "simulation/camera/CameraView.h"
#include "simulation/camera/Lanes.h"

namespace gt {

/// A point of the image (pixels).
struct ScreenPoint {
  /// Number of additional points that an array has room for, since four are computed at once.
  static constexpr int spare = 4;

  float x = 0, y = 0;
};

/// The inverse depth (1 / distance along the optical axis, 1/m) of a plane at each place
/// of the image; within a row it is linear.
struct ScreenPlane {
  float first0 = 0, first1 = 0, first2 = 0, column0 = 0, column1 = 0, distance0 = 1, distance1 = 0;
  bool clockwise = true;  ///< Whether the polygon's points are clockwise in the image.

  /// Inverse depth at column 0 of several rows at once, before the division by `distanceAt`.
  Floats firstColumnAt(Floats y) const { return first0 + y * (first1 + y * first2); }
  Floats perColumnAt(Floats y) const { return column0 + y * column1; }
  /// The divisor of `firstColumnAt` and `perColumnAt`.
  Floats distanceAt(Floats y) const { return distance0 + y * distance1; }
};

/// Maps points in space to the image, for a camera that moves while its rows are exposed one after
/// another. Lengths are meters. The camera's system is that of the moment halfway through the
/// exposure of the image.
///
/// In the image, the center of pixel (x, y) is at (x + 0.5, y + 0.5).
class Projection {
 public:
  enum class Visibility { hidden, partly, whole };
  static constexpr float nearest = 0.01f;  ///< Distance of the near plane, m.

  void set(const CameraView& view, bool rollingShutter);

  Eigen::Vector3f toCamera(const Eigen::Vector3f& point) const {
    return rotation_ * (point - position_);
  }
  const Eigen::Matrix3f& rotation() const { return rotation_; }
  /// Pixels per radian in the image's center.
  float focal() const { return focalX_; }
  /// Whether straight edges are bent, by the camera's motion or by its lens.
  bool bends() const { return moves_ || distorts_; }

  /// Whether a sphere is in view, partly or as a whole. `center` is in the camera's system (m).
  Visibility visibility(const Eigen::Vector3f& center, float radius) const;

  /// Projects points ahead of the camera, in its system, to the image. For each point, the moment
  /// is sought at which the row is exposed in which the point lies at that moment. `seen` must have
  /// room for `ScreenPoint::spare` more points.
  void project(const Eigen::Vector3f* points, int count, ScreenPoint* seen) const;

  /// Computes the plane through the points of a convex polygon in the camera's system. Returns
  /// false if the camera lies in the plane, so that nothing of it is seen.
  bool planeOf(const Eigen::Vector3f* points, int count, ScreenPlane& plane) const;

  /// Clips a convex polygon in the camera's system to the view; `points` must have room for five
  /// more. Returns the new number of points, 0 if none is left.
  int clip(Eigen::Vector3f* points, int count) const;

 private:
  static constexpr int maxPoints = 64;
  static constexpr int planeCount = 5;

  /// Projects a point in the camera's system through the lens. `moved` is the point when the row is
  /// exposed in which it would appear without the lens's distortion.
  ScreenPoint projectByLens(const Eigen::Vector3f& point, const Eigen::Vector3f& moved) const;

  Eigen::Matrix3f rotation_ = Eigen::Matrix3f::Identity();
  Eigen::Vector3f position_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f turning_ = Eigen::Vector3f::Zero();  ///< Over the whole exposure.
  Eigen::Vector3f moving_ = Eigen::Vector3f::Zero();
  float focalX_ = 1, focalY_ = 1, centerX_ = 0, centerY_ = 0;
  float rowOffset_ = 0, rowShare_ = 0, middleRow_ = 0;
  bool moves_ = false, distorts_ = false;
  float distortion2_ = 0, distortion4_ = 0, distortionLimit_ = 0;  ///< As in LensDistortion.
  std::array<Eigen::Vector3f, planeCount> normals_;
  std::array<float, planeCount> offsets_{};
};

inline Projection::Visibility Projection::visibility(const Eigen::Vector3f& center,
                                                     float radius) const {
  float least = radius;
  for (std::size_t i = 0; i < planeCount; ++i)
    least = std::min(least, normals_[i].dot(center) - offsets_[i]);
  return least <= -radius ? Visibility::hidden
         : least < radius ? Visibility::partly
                          : Visibility::whole;
}

}  // namespace gt
