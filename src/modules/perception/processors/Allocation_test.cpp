#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "base/Random.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/processors/GridImageProcessor2.h"
#include "modules/perception/processors/GridImageProcessor3.h"
#include "modules/perception/processors/LinesImageProcessor.h"
#include "modules/perception/testing/FoundPercepts.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

/// Images full of colors make the lists of an image processor as long as they get; then they
/// keep their memory.
class ColorfulImages : public testing::Test {
 protected:
  ColorfulImages() {
    for (ColorClass& c : colors_.classes)
      c = static_cast<ColorClass>(random_.index(enumCount<ColorClass>));
    image_.allocate();
    for (Pixel& p : patches_)
      p = {static_cast<std::uint8_t>(random_()), static_cast<std::uint8_t>(random_()),
           static_cast<std::uint8_t>(random_()), 0};
    matrix_.pose.translation.z() = 170;
    matrix_.valid = true;
  }

  /// Has processor.update(image, matrix, colors..., percepts, rest...) look at them.
  template <typename Processor, typename... Colors>
  void expectNoAllocations(Processor& processor, const std::tuple<const Colors&...>& colors,
                           auto&... rest) {
    const auto look = [&](std::uint64_t seed) {
      draw(seed);
      std::apply(
          [&](const auto&... c) {
            processor.update(image_, matrix_, c..., FieldDimensions{}, found_, rest..., debug_);
          },
          colors);
    };
    // Until what is learned of the colors repeats itself, too.
    for (int round = 0; round < 10; ++round)
      for (std::uint64_t seed = 0; seed < 50; ++seed) look(seed);
    const long before = allocations();
    for (std::uint64_t seed = 0; seed < 50; ++seed) look(seed);
    EXPECT_EQ(allocations(), before);
    patches_.push_back({});
    EXPECT_GT(allocations(), before) << "the counter does not count";
  }

  Random random_{1};
  ColorTable64 colors_;

 private:
  void draw(std::uint64_t seed) {
    Random own{seed};
    Pixel pixel;
    for (Pixel& p : image_.pixels) {
      if (own.chance(0.2)) pixel = patches_[own.index(patches_.size())];
      p = pixel;
    }
    matrix_.pose.rotation = rotationY(own.uniform(-0.5, 0.5)) * rotationX(own.uniform(-0.3, 0.3));
  }

  std::vector<Pixel> patches_ = std::vector<Pixel>(16);
  Image image_;
  CameraMatrix matrix_;
  FoundPercepts found_;
  Debug debug_;
};

TEST_F(ColorfulImages, NeedNoMemoryOfGT2003) {
  GT2003ImageProcessor processor;
  expectNoAllocations(processor, std::tie(std::as_const(colors_)));
}

TEST_F(ColorfulImages, NeedNoMemoryOfGridImageProcessor2) {
  GridImageProcessor2 processor;
  expectNoAllocations(processor, std::tuple<>{});
}

TEST_F(ColorfulImages, NeedNoMemoryOfGridImageProcessor3) {
  GridImageProcessor3 processor;
  expectNoAllocations(processor, std::tie(std::as_const(colors_)), random_);
}

TEST_F(ColorfulImages, NeedNoMemoryOfLines) {
  LinesImageProcessor processor;
  expectNoAllocations(processor, std::tie(std::as_const(colors_)));
}

}  // namespace
}  // namespace gt
