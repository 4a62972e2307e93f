#pragma once
#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// The mean of the focal lengths (pixels).
inline double focalLength(const CameraInfo& info) {
  return (info.focalX + info.focalY) / 2;
}

/// Fills in where a ball is of which the cone of rays that touch it is known: its axis, and the
/// angle between both (rad), 0 if that is not known (report 3.2.3). All but `time` and `seen`;
/// false if that is no ball on a field.
bool describeBall(const CameraImage& picture, const Vector3d& axis, double angle, double ballRadius,
                  BallPercept& percept);

/// Whether a described ball lies on the ground, as far as its size and the camera matrix can be
/// trusted.
bool isOnGround(const CameraImage& picture, const BallPercept& percept, const Vector3d& axis,
                double ballRadius);

}  // namespace gt
