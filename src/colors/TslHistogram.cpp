#include "colors/TslHistogram.h"

#include <cmath>

namespace gt {

void TslHistogram::add(const Tsl& color, std::uint64_t times) {
  tint_.add(color.tint, times);
  saturation_.add(color.saturation, times);
  luminance_.add(color.luminance, times);
}

TslThresholds TslHistogram::thresholds(double share) const {
  if (tint_.total() == 0) return {};
  TslThresholds found{0, tint_.narrowest(share), saturation_.narrowest(share),
                      luminance_.narrowest(share)};
  if (circularWidth(found.tint, 256) > 128) {
    found.tint = {0, 255};
    found.saturation[0] = 0;
  }
  return found;
}

Image withNoise(const Image& image, double standardDeviation, Random& random) {
  Image noisy = image;
  for (Pixel& pixel : noisy.pixels)
    for (std::uint8_t* value : {&pixel.y, &pixel.cb, &pixel.cr})
      *value = static_cast<std::uint8_t>(
          std::lround(std::clamp(*value + standardDeviation * random.gaussian(), 0.0, 255.0)));
  return noisy;
}

}  // namespace gt
