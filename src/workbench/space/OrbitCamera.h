#pragma once
#include <QJsonObject>
#include <optional>

#include "base/Geometry.h"

namespace gt {

/// Where a ray begins and its direction (length 1), in mm on the field.
struct Ray {
  Vector3d from, direction;

  /// Where it meets a plane parallel to the ground at a height (mm); empty if it does not.
  std::optional<Vector3d> atHeight(double height) const;
};

/// A viewer's camera that goes round a point and looks at it.
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

  /// Goes round by pixels of a mouse that drags.
  void turn(double x, double y);
  /// Moves the point along the ground, so that it follows a mouse that drags by pixels of an image
  /// with this height.
  void move(double x, double y, double height);
  /// Goes nearer by steps of a wheel.
  void approach(double steps);

  QJsonObject settings() const;
  void restore(const QJsonObject& settings);
};

}  // namespace gt
