#pragma once
#include <vector>

#include "simulation/camera/CameraView.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// Smears an image along the ways that its points go while a row is exposed, because the camera
/// turns.
class MotionBlur {
 public:
  /// Each pixel gets the mean of what passes it in `exposure` milliseconds, half of them before and
  /// half of them after the moment at which it was drawn; its class stays.
  void apply(const CameraView& view, double exposure, Rasterizer& picture);

 private:
  std::vector<PackedColor> sharp_;
};

}  // namespace gt
