#pragma once
#include "streams/Reflection.h"

namespace gt {

/// A camera at the ceiling that measures where robots and ball are (report 6.2.2). Element
/// `ceilingCamera`; a scene without it has none.
struct CeilingCameraParameters {
  double positionNoise = 6;
  double rotationNoise = 0.02;
  double scaleError = 0.002;
  double offsetError = 8;
  double overlooked = 0.02;
  double lowX = -1e4, highX = 1e4;
  int period = 40;
  bool oracle = false;

  static constexpr auto fields() {
    using P = CeilingCameraParameters;
    return Fields{field("positionNoise", &P::positionNoise, "mm",
                        "standard deviation of each coordinate in each image", {0, 1000}),
                  field("rotationNoise", &P::rotationNoise, "rad", "standard deviation", {0, 3}),
                  field("scaleError", &P::scaleError, "",
                        "of the calibration: at most, in each direction", {0, 0.5}),
                  field("offsetError", &P::offsetError, "mm", "likewise", {0, 1000}),
                  field("overlooked", &P::overlooked, "",
                        "share of images in which a thing is missed", {0, 1}),
                  field("lowX", &P::lowX, "mm",
                        "where its view begins, such as the middle of the field", {-1e4, 1e4}),
                  field("highX", &P::highX, "mm", "where it ends", {-1e4, 1e4}),
                  field("period", &P::period, "ms", "from image to image", {8, 10'000}),
                  field("oracle", &P::oracle, "",
                        "the oracle reports what this camera saw instead of the truth")};
  }
};

}  // namespace gt
