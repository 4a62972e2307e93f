#pragma once
#include <optional>

#include "modules/perception/scanning/CameraImage.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// Greatest distance of a place on a field: its diagonal (mm).
constexpr double farthestOnGround = 5000;

/// Projects a point of the image (pixels) to a plane parallel to the ground at `height` (mm).
/// Returns the position relative to the robot (mm); nothing if it is farther from the camera than
/// `farthestOnGround`, or not in the direction of the plane.
std::optional<Vector2d> onPlane(const CameraImage& picture, const Vector2d& inImage, double height);
inline std::optional<Vector2d> onGround(const CameraImage& picture, const Vector2d& inImage) {
  return onPlane(picture, inImage, 0);
}

/// The width of a field line and the height of the field border in the image (pixels), along a line
/// perpendicular to the horizon, at a distance (mm, on the ground) from the camera (report 3.2.2).
double expectedLineWidth(const CameraImage& picture, double distance, const FieldDimensions& field);
double expectedBorderHeight(const CameraImage& picture, double distance,
                            const FieldDimensions& field);

}  // namespace gt
