#include "images/Jpeg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/Random.h"

namespace gt {
namespace {

/// An image of smooth colors, four bytes a pixel.
std::vector<std::uint8_t> sample(int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int c : {x, 255 - y, (x + y) / 2, 77})
        pixels.push_back(static_cast<std::uint8_t>(c));
  return pixels;
}

TEST(Jpeg, KeepsTheImage) {
  const auto pixels = sample(176, 144);
  const auto packed = encodeJpeg(pixels.data(), 176, 144, 4, 95);
  EXPECT_LT(packed.size(), pixels.size() / 8);
  const auto picture = decodeJpeg(packed);
  ASSERT_TRUE(picture) << picture.error().text();
  ASSERT_EQ(picture->width, 176);
  ASSERT_EQ(picture->height, 144);
  ASSERT_EQ(picture->components, 3);
  int worst = 0;
  for (std::size_t i = 0; i < 176 * 144; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(pixels[4 * i + c] - picture->data[3 * i + c]));
  EXPECT_LE(worst, 4);
}

TEST(Jpeg, TakesOnePixel) {
  const std::uint8_t pixel[3] = {10, 20, 30};
  const auto picture = decodeJpeg(encodeJpeg(pixel, 1, 1, 3, 100));
  ASSERT_TRUE(picture);
  EXPECT_NEAR(picture->data[2], 30, 1);
}

TEST(Jpeg, SurvivesTruncatedAndMutatedData) {
  const auto good = encodeJpeg(sample(32, 32).data(), 32, 32);
  EXPECT_FALSE(decodeJpeg({}));
  int failures = 0;
  for (std::size_t n = 0; n + 2 < good.size(); ++n)
    failures += decodeJpeg(std::span{good}.first(n)) ? 0 : 1;
  EXPECT_EQ(failures, static_cast<int>(good.size()) - 2);
  Random random{7};
  failures = 0;
  for (int i = 0; i < 3000; ++i) {
    auto bad = good;
    for (int k = 0; k < 3; ++k) bad[random.index(bad.size())] = static_cast<std::uint8_t>(random());
    failures += decodeJpeg(bad) ? 0 : 1;
  }
  EXPECT_GT(failures, 500);
}

}  // namespace
}  // namespace gt
