#pragma once
#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// The mean of the focal lengths (pixels).
inline double focalLength(const CameraInfo& info) {
  return (info.focalX + info.focalY) / 2;
}

/// Where a ball is seen: the cone of rays that touch it.
struct BallCone {
  Vector3d axis = Vector3d::UnitX();
  double angle = 0;  ///< Between axis and surface, rad; 0 if it is not known.
  double error = 0;  ///< Standard deviation of the angle, rad.
};

/// Fills in where a ball is of which the cone is known (report 3.2.3). Its distance is the mean of
/// that by size and that by projection, weighted by how exact they are. All but `time` and `seen`;
/// false if that is no ball on a field.
bool describeBall(const CameraImage& picture, const BallCone& cone, double ballRadius,
                  BallPercept& percept);

/// Whether a described ball lies on the ground, as far as its size and the camera matrix can be
/// trusted.
bool isOnGround(const CameraImage& picture, const BallPercept& percept, const Vector3d& axis,
                double ballRadius);

}  // namespace gt
