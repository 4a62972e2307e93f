#pragma once
#include <QJsonObject>
#include <optional>

#include "base/Geometry.h"

namespace gt {

/// A ray: its origin (mm, on the field) and its direction (length 1).
struct Ray {
  Vector3d from, direction;

  /// The point where the ray meets a plane parallel to the ground at a height (mm); empty if it
  /// does not.
  std::optional<Vector3d> atHeight(double height) const;
};

/// A viewer's camera that orbits a point and looks at it.
struct OrbitCamera {
  Vector3d at{0, 0, 0};      ///< mm on the field
  double azimuth = -90;      ///< degrees, of where the camera is as seen from the point
  double elevation = 33;     ///< degrees above the ground
  double distance = 4200;    ///< mm
  double openingAngle = 45;  ///< degrees, from top to bottom: the perspective's distortion
  double nearest = 100, farthest = 20000;  ///< mm

  Vector3d from() const;
  Vector3d ahead() const { return (at - from()).normalized(); }
  Vector3d up() const;
  /// The ray through a point of the image: x to the right and y upward, each from -1 to 1; aspect
  /// is the image's width by its height.
  Ray ray(double x, double y, double aspect) const;

  /// Orbits the point as the mouse is dragged by x and y pixels.
  void turn(double x, double y);
  /// Moves the point along the ground, so that it follows a mouse that is dragged by x and y pixels
  /// of an image with a height (pixels).
  void move(double x, double y, double height);
  /// Moves the camera nearer by steps of a wheel.
  void approach(double steps);

  QJsonObject settings() const;
  void restore(const QJsonObject& settings);
};

}  // namespace gt
