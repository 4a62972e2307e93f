#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/CameraInfo.h"

namespace gt {

/// From where a picture is taken. Provided by the simulated robot.
struct CameraView {
  CameraInfo info;
  Pose3D first;         ///< On the field when row 0 is exposed, mm, x along the optical axis.
  Pose3D last;          ///< The same when the last row is exposed.
  int hiddenBody = -1;  ///< The MuJoCo body around the camera, which is not drawn; -1 for none.
};

}  // namespace gt
