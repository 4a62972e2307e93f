#pragma once
#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// The mean of the focal lengths (pixels).
inline double focalLength(const CameraInfo& info) {
  return (info.focalX + info.focalY) / 2;
}

/// The cone of rays from the camera that touch a ball.
struct BallCone {
  Vector3d axis = Vector3d::UnitX();  ///< Unit vector in the robot's system.
  double angle = 0;                   ///< Between axis and surface, rad; 0 if unknown.
  double error = 0;                   ///< Standard deviation of the angle, rad.
};

/// Fills in the position of a ball from its cone (report 3.2.3), all members except `time` and
/// `seen`. The distance is the mean of the distance by size and the distance by projection,
/// weighted by their accuracy. Returns false if it cannot be a ball on a field. `ballRadius` in mm.
bool describeBall(const CameraImage& picture, const BallCone& cone, double ballRadius,
                  BallPercept& percept);

/// Returns whether a ball filled in by describeBall lies on the ground, within the tolerance of its
/// size and of the camera matrix. True without a valid matrix.
bool isOnGround(const CameraImage& picture, const BallPercept& percept, const Vector3d& axis,
                double ballRadius);

}  // namespace gt
