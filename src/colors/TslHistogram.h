#pragma once
#include "base/Random.h"
#include "colors/ChannelHistogram.h"
#include "colors/LabeledImage.h"
#include "colors/TslColors.h"

namespace gt {

/// Histograms of T', S' and L' in a region of an image, from which thresholds are derived (report
/// J.6.3).
class TslHistogram {
 public:
  void add(const Image& image, const ImageRegion& region) {
    region.forEachPixel(image, [&](const Pixel& pixel) { add(tslOf(pixel)); });
  }
  void add(const Tsl& color, std::uint64_t times = 1);

  const ChannelHistogram& tint() const { return tint_; }
  const ChannelHistogram& saturation() const { return saturation_; }
  const ChannelHistogram& luminance() const { return luminance_; }

  /// The *Auto* button: the narrowest thresholds that contain a share (above 0, up to 1) of the
  /// counted values in each channel. If the tints are distributed around the whole circle, the
  /// color is gray, and its saturation begins at 0. The priority is 0.
  TslThresholds thresholds(double share = 0.99) const;

 private:
  ChannelHistogram tint_{256, true}, saturation_{256}, luminance_{256};
};

/// Adds noise of a standard deviation to all channels of an image: the *Noise* slider, which shows
/// how robust a classification is.
Image withNoise(const Image& image, double standardDeviation, Random& random);

}  // namespace gt
