#include "colors/TslHistogram.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "colors/ColorConfusion.h"
#include "support/HalvedImage.h"

namespace gt {
namespace {

TEST(TslHistogram, SetsThresholdsFromARegion) {
  Random random{8};
  const Pixel orange{140, 70, 190, 0}, green{90, 110, 100, 0};
  const Image image = withNoise(halvedImage(orange, green), 3, random);
  TslHistogram histogram;
  histogram.add(image, {-5, 2, 19, 300});  // what lies outside of the image does not count
  EXPECT_EQ(histogram.tint().total(), 20u * 18u);
  TslColors colors;
  colors.classes[ColorClass::orange] = histogram.thresholds(0.99);
  ColorConfusion confusion;
  const auto classify = [&](const Image& picture) {
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x)
        confusion.add(x < 20 ? ColorClass::orange : ColorClass::noColor, colors[picture.at(x, y)]);
  };
  classify(image);
  EXPECT_GT(confusion.recall(ColorClass::orange), 0.97);
  EXPECT_EQ(confusion.precision(ColorClass::orange), 1);
  // The thresholds are as narrow as they can be: with twice the noise much is lost.
  confusion = {};
  classify(withNoise(image, 6, random));
  EXPECT_LT(confusion.recall(ColorClass::orange), 0.9);
  EXPECT_EQ(TslHistogram{}.thresholds(), TslThresholds{});
}

}  // namespace
}  // namespace gt
