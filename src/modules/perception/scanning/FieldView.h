#pragma once
#include <optional>

#include "modules/perception/scanning/CameraImage.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// No place on a field is further away than its diagonal (mm).
constexpr double farthestOnGround = 5000;

/// Where a point of the image lies in a plane parallel to the ground (mm, robot's system);
/// nothing if it is further away than any place on a field.
std::optional<Vector2d> onPlane(const CameraImage& picture, const Vector2d& inImage, double height);
inline std::optional<Vector2d> onGround(const CameraImage& picture, const Vector2d& inImage) {
  return onPlane(picture, inImage, 0);
}

/// How long things are in the image at a distance from the camera on the ground, along a line
/// perpendicular to the horizon (pixels; report 3.2.2).
double expectedLineWidth(const CameraImage& picture, double distance, const FieldDimensions& field);
double expectedBorderHeight(const CameraImage& picture, double distance,
                            const FieldDimensions& field);

}  // namespace gt
