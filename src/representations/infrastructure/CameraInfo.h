#pragma once
#include <cmath>

#include "base/Geometry.h"
#include "representations/infrastructure/LensDistortion.h"
#include "streams/Reflection.h"

namespace gt {

/// Size and optics of the camera that took an image: data, so that other robots' images run
/// through the same code. The defaults are the ERS-210's (facts, 1.3).
struct CameraInfo {
  int width = 176;
  int height = 144;
  double focalX = 160.1;
  double focalY = 162.5;
  double centerX = 88;
  double centerY = 72;
  double rowTime = 0.23;
  double distortion2 = 0;
  double distortion4 = 0;

  /// The direction to a point of the image (pixels) in the camera's system (x along the optical
  /// axis, y left, z up), not normalized; the distortion of the lens is removed.
  Vector3d ray(double x, double y) const {
    const Vector3d seen{1, (centerX - x) / focalX, (centerY - y) / focalY};
    if (distortion().none()) return seen;
    const double factor = distortion().undoing(seen.tail<2>().squaredNorm());
    return {1, factor * seen.y(), factor * seen.z()};
  }
  /// Projects a point in the camera's system (mm) to the image (pixels); its x must be positive.
  Vector2d project(const Vector3d& inCamera) const {
    const Vector2d offset{focalX * inCamera.y() / inCamera.x(),
                          focalY * inCamera.z() / inCamera.x()};
    const Vector2d center{centerX, centerY};
    return distortion().none() ? center - offset : center - distorted(offset);
  }
  LensDistortion distortion() const { return {distortion2, distortion4}; }
  /// Applies the distortion of the lens to an offset from the optical axis (pixels).
  Vector2d distorted(const Vector2d& offset) const {
    const double x = offset.x() / focalX, y = offset.y() / focalY;
    return distortion().factor(x * x + y * y) * offset;
  }
  double openingAngleX() const {
    return std::atan(ray(0, centerY).y()) - std::atan(ray(width, centerY).y());
  }
  double openingAngleY() const {
    return std::atan(ray(centerX, 0).z()) - std::atan(ray(centerX, height).z());
  }
  bool contains(double x, double y) const { return x >= 0 && y >= 0 && x < width && y < height; }

  static constexpr auto fields() {
    return Fields{
        field<&CameraInfo::width>(Unit::pixel, {1, 4096}),
        field<&CameraInfo::height>(Unit::pixel, {1, 4096}),
        field<&CameraInfo::focalX>(Unit::pixel, "focal length over pixel width", {1, 1e5}),
        field<&CameraInfo::focalY>(Unit::pixel, "focal length over pixel height", {1, 1e5}),
        field<&CameraInfo::centerX>(Unit::pixel, "where the optical axis meets the image"),
        field<&CameraInfo::centerY>(Unit::pixel),
        field<&CameraInfo::rowTime>(Unit::ms, "from the exposure of a row to that of the next",
                                    {0, 10}),
        field<&CameraInfo::distortion2>("of the lens: k2 of LensDistortion", {-1, 1}),
        field<&CameraInfo::distortion4>("k4 of LensDistortion", {-1, 1})};
  }
};

}  // namespace gt
