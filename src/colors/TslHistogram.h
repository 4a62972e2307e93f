#pragma once
#include "base/Random.h"
#include "colors/ChannelHistogram.h"
#include "colors/LabeledImage.h"
#include "colors/TslColors.h"

namespace gt {

/// How often each value of T', S' and L' occurs in a region of an image, and which thresholds
/// follow from it (report J.6.3).
class TslHistogram {
 public:
  void add(const Image& image, const ImageRegion& region) {
    region.forEachPixel(image, [&](const Pixel& pixel) { add(tslOf(pixel)); });
  }
  void add(const Tsl& color, std::uint64_t times = 1);

  const ChannelHistogram& tint() const { return tint_; }
  const ChannelHistogram& saturation() const { return saturation_; }
  const ChannelHistogram& luminance() const { return luminance_; }

  /// The *Auto* button: the narrowest thresholds that hold a share of what was seen in each channel
  /// (above 0, up to 1). What has tints all round is gray: its saturation begins at 0. The
  /// priority is 0.
  TslThresholds thresholds(double share = 0.99) const;

 private:
  ChannelHistogram tint_{256, true}, saturation_{256}, luminance_{256};
};

/// An image with noise of a standard deviation added to all channels: the *Noise* slider, by
/// which one sees how robust a classification is.
Image withNoise(const Image& image, double standardDeviation, Random& random);

}  // namespace gt
