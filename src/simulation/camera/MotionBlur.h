#pragma once
#include <vector>

#include "simulation/camera/CameraView.h"
#include "simulation/camera/Rasterizer.h"

namespace gt {

/// Smears an image along the ways that its points go while a row is exposed, because the camera
/// turns. Pixels of a block of 16 x 8 are smeared over the distance that its middle moves.
class MotionBlur {
 public:
  /// Each pixel gets the mean of what passes it in `exposure` milliseconds, half of them before and
  /// half of them after the moment at which it was drawn; its class stays.
  void apply(const CameraView& view, double exposure, Rasterizer& picture);

 private:
  void copySharp(const Rasterizer& picture);
  /// The first of the bytes of a pixel of the sharp image and of those beside it.
  const std::uint8_t* sharpAt(int x, int y) const;

  std::vector<PackedColor> sharp_;  ///< With margins on both sides, as their outermost pixels.
  int stride_ = 0;
};

}  // namespace gt
