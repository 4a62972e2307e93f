// What vision is without a grid, by OpenCV: the whole image segmented by color, then the
// connected regions of each color.
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "benchmarks/GameImages.h"
#include "benchmarks/Parts.h"

namespace gt {
namespace {

/// The Y, Cb and Cr that most entries of a color class lie between.
struct ColorRange {
  cv::Scalar low, high;
};

constexpr std::array classes{ColorClass::orange, ColorClass::yellow, ColorClass::skyblue,
                             ColorClass::pink,   ColorClass::red,    ColorClass::blue,
                             ColorClass::green,  ColorClass::white};

ColorRange rangeOf(ColorClass color) {
  std::array<std::vector<int>, 3> values;
  for (std::size_t i = 0; i < gameColors().classes.size(); ++i) {
    if (gameColors().classes[i] != color) continue;
    for (std::size_t channel = 0; channel < 3; ++channel)
      values[channel].push_back(static_cast<int>(i >> (12 - 6 * channel) & 63) * 4);
  }
  ColorRange range;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    auto& list = values[channel];
    if (list.empty()) continue;
    std::sort(list.begin(), list.end());
    range.low[static_cast<int>(channel)] = list[list.size() / 20];
    range.high[static_cast<int>(channel)] = list[list.size() - 1 - list.size() / 20] + 3;
  }
  range.high[3] = 255;
  return range;
}

void segmentation(benchmark::State& state) {
  cv::setNumThreads(1);
  std::vector<ColorRange> ranges;
  for (const ColorClass color : classes) ranges.push_back(rangeOf(color));
  cv::Mat mask, labels, regions, middles;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Image& image = gameImages()[i++ % gameImages().size()].image;
    const cv::Mat picture(image.info.height, image.info.width, CV_8UC4,
                          const_cast<Pixel*>(image.pixels.data()));
    for (const ColorRange& range : ranges) {
      cv::inRange(picture, range.low, range.high, mask);
      benchmark::DoNotOptimize(cv::connectedComponentsWithStats(mask, labels, regions, middles));
    }
  }
}

BENCHMARK(segmentation)->Name("speed.vision.opencv")->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
