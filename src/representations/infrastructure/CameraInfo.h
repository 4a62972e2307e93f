#pragma once
#include <cmath>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// Size and optics of the camera that took a picture: data, so that other robots' pictures run
/// through the same code. The defaults are the ERS-210's (facts, 1.3).
struct CameraInfo {
  int width = 176;
  int height = 144;
  double focalX = 160.1;
  double focalY = 162.5;
  double centerX = 88;
  double centerY = 72;
  double rowTime = 0.23;

  /// The direction of a point of the picture in the camera's system (x along the optical axis, y
  /// left, z up), not normalized.
  Vector3d ray(double x, double y) const {
    return {1, (centerX - x) / focalX, (centerY - y) / focalY};
  }
  /// Where a point in the camera's system is seen; its x must be positive.
  Vector2d project(const Vector3d& inCamera) const {
    return {centerX - focalX * inCamera.y() / inCamera.x(),
            centerY - focalY * inCamera.z() / inCamera.x()};
  }
  double openingAngleX() const { return 2 * std::atan(width / (2 * focalX)); }
  double openingAngleY() const { return 2 * std::atan(height / (2 * focalY)); }
  bool contains(double x, double y) const { return x >= 0 && y >= 0 && x < width && y < height; }

  static constexpr auto fields() {
    return Fields{
        field("width", &CameraInfo::width, "pixel", "", {1, 4096}),
        field("height", &CameraInfo::height, "pixel", "", {1, 4096}),
        field("focalX", &CameraInfo::focalX, "pixel", "focal length over pixel width", {1, 1e5}),
        field("focalY", &CameraInfo::focalY, "pixel", "focal length over pixel height", {1, 1e5}),
        field("centerX", &CameraInfo::centerX, "pixel", "where the optical axis meets the picture"),
        field("centerY", &CameraInfo::centerY, "pixel"),
        field("rowTime", &CameraInfo::rowTime, "ms",
              "from the exposure of a row to that of the next", {0, 10})};
  }
};
static_assert(complete<CameraInfo>);

}  // namespace gt
