#pragma once
#include "simulation/camera/CameraView.h"
#include "simulation/camera/ImagePlanes.h"

namespace gt {

/// Smears an image along the paths of its points while a row is exposed and the camera turns. All
/// pixels of a block of 32 x 8 are smeared over the distance that the middle of the block moves.
class MotionBlur {
 public:
  /// Each pixel gets the mean of the pixels that pass it during `exposure` (ms), half of that time
  /// before and half of it after the moment at which it was drawn.
  void apply(const CameraView& view, double exposure, ImagePlanes& picture);

 private:
  ImagePlanes sharp_;
};

}  // namespace gt
