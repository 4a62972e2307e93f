#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/CameraInfo.h"

namespace gt {

/// A pose between two others: `share` 0 is the first, 1 the second.
inline Pose3D interpolated(const Pose3D& a, const Pose3D& b, double share) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond{a.rotation}.slerp(share, Eigen::Quaterniond{b.rotation});
  return {rotation.toRotationMatrix(), (1 - share) * a.translation + share * b.translation};
}

/// The pose and optics with which an image is taken. Provided by the simulation.
struct CameraView {
  CameraInfo info;
  Pose3D first;         ///< On the field when row 0 is exposed, mm, x along the optical axis.
  Pose3D last;          ///< On the field when the last row is exposed, as `first`.
  int hiddenBody = -1;  ///< The MuJoCo body around the camera, which is not drawn; -1 for none.
};

}  // namespace gt
