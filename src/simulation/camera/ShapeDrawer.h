#pragma once
#include <mujoco/mujoco.h>

#include "simulation/camera/CameraScene.h"
#include "simulation/camera/Projection.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// Turns a shape into the few polygons that a camera sees of it. Round forms are cut along their
/// outline as seen from the camera, so that the outline is true with few polygons.
class ShapeDrawer {
 public:
  ShapeDrawer(const CameraScene& scene, const Projection& projection, Rasterizer& rasterizer)
      : scene_{scene}, projection_{projection}, rasterizer_{rasterizer} {}

  /// Draws a shape at the pose of its geom: `position` (m) and `axes` (row by row) are MuJoCo's.
  void draw(const CameraShape& shape, const mjtNum* position, const mjtNum* axes);

 private:
  using Vector = Eigen::Vector3f;

  void plane();
  void box();
  void mesh();
  void cylinder();
  void capsule();
  /// Draws the visible part of an ellipsoid at an offset along the shape's z-axis.
  void ellipsoid(const Vector& radii, float offset);
  /// Draws the side of a cylinder, up to its outline on both sides.
  void mantle(float radius, float halfLength);
  void lid(float radius, float height);

  /// A convex polygon in the camera's system; `points_` holds its points.
  void polygon(int count, PackedColor color);
  int bend(int count);
  /// Length in the image (pixels) of a length (m) at the shape's distance; at most the focal
  /// length.
  float pixelsOf(float length) const;
  PackedColor shade(const Vector& normal) const;
  /// From the shape's system to the camera's.
  Vector place(const Vector& point) const { return center_ + axes_ * point; }

  static constexpr int maxPoints = 64, maxScreenPoints = 512;

  const CameraScene& scene_;
  const Projection& projection_;
  Rasterizer& rasterizer_;

  const CameraShape* shape_ = nullptr;
  bool clipped_ = false, bent_ = false;
  Vector center_;            ///< In the camera's system.
  Eigen::Matrix3f axes_;     ///< From the shape's system to the camera's.
  Vector eye_, light_, up_;  ///< In the shape's system.
  Vector points_[maxPoints];
  Vector bentPoints_[maxScreenPoints];
  ScreenPoint screen_[maxScreenPoints + ScreenPoint::spare];
};

}  // namespace gt
