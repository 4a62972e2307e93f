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
    return Fields{
        field<&P::positionNoise>(Unit::mm, "standard deviation of each coordinate in each image",
                                 {0, 1000}),
        field<&P::rotationNoise>(Unit::rad, "standard deviation", {0, 3}),
        field<&P::scaleError>("error of the calibration's scale: at most, in each direction",
                              {0, 0.5}),
        field<&P::offsetError>(
            Unit::mm, "error of the calibration's origin: at most, in each direction", {0, 1000}),
        field<&P::overlooked>("share of images in which a thing is missed", {0, 1}),
        field<&P::lowX>(Unit::mm, "where its view begins, such as the middle of the field",
                        {-1e4, 1e4}),
        field<&P::highX>(Unit::mm, "where it ends", {-1e4, 1e4}),
        field<&P::period>(Unit::ms, "from image to image", {8, 10'000}),
        field<&P::oracle>("the oracle reports what this camera saw instead of the truth")};
  }
};

}  // namespace gt
