#pragma once
#include "simulation/camera/CameraView.h"
#include "simulation/camera/ImagePlanes.h"

namespace gt {

/// Smears an image along the paths that its points go while a row is exposed, because the camera
/// turns. Pixels of a block of 32 x 8 are smeared over the distance that its middle moves.
class MotionBlur {
 public:
  /// Each pixel gets the mean of what passes it in `exposure` milliseconds, half of them before and
  /// half of them after the moment at which it was drawn.
  void apply(const CameraView& view, double exposure, ImagePlanes& picture);

 private:
  ImagePlanes sharp_;
};

}  // namespace gt
