#include "simulation/camera/ImagePlanes.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

constexpr int height = 3;

/// A picture each of whose channels has another value in each pixel.
Rasterizer pictureOf(int width) {
  Rasterizer picture;
  picture.begin(width, height, 0, false);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<PackedColor>(7 * x + 31 * y) & 255;
      picture.row(y)[x] = value | (255 - value) << 8 | (value ^ 85) << 16;
    }
  return picture;
}

class Widths : public testing::TestWithParam<int> {};

TEST_P(Widths, AreTakenApartAndPutTogether) {
  const Rasterizer picture = pictureOf(GetParam());
  ImagePlanes planes;
  takePlanes(picture, planes);
  Image image;
  image.info.width = GetParam();
  image.info.height = height;
  image.allocate();
  joinPlanes(planes, image);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < GetParam(); ++x) {
      const PackedColor drawn = picture.row(y)[x];
      const Pixel pixel = image.at(x, y);
      EXPECT_EQ(PackedColor{pixel.y}, drawn & 255) << x << ", " << y;
      EXPECT_EQ(PackedColor{pixel.cb}, drawn >> 8 & 255) << x << ", " << y;
      EXPECT_EQ(PackedColor{pixel.cr}, drawn >> 16 & 255) << x << ", " << y;
    }
}

TEST_P(Widths, HaveMarginsOfTheOutermostPixels) {
  ImagePlanes planes;
  takePlanes(pictureOf(GetParam()), planes);
  Plane& plane = planes[1];
  const std::uint8_t above = plane.row(0)[GetParam() - 1], below = plane.row(2)[0];
  plane.fillMargins(1);
  for (int i = 1; i <= Plane::margin; ++i) {
    EXPECT_EQ(plane.row(1)[-i], plane.row(1)[0]);
    EXPECT_EQ(plane.row(1)[GetParam() - 1 + i], plane.row(1)[GetParam() - 1]);
  }
  EXPECT_EQ(plane.row(0)[GetParam() - 1], above);
  EXPECT_EQ(plane.row(2)[0], below);
}

INSTANTIATE_TEST_SUITE_P(ImagePlanes, Widths, testing::Values(5, 33, 176, 208));

TEST(ImagePlanes, RowsBeyondTheImageAreTheNearest) {
  Plane plane;
  plane.resize(8, height);
  EXPECT_EQ(plane.nearestRow(-2), plane.row(0));
  EXPECT_EQ(plane.nearestRow(1), plane.row(1));
  EXPECT_EQ(plane.nearestRow(height), plane.row(height - 1));
}

}  // namespace
}  // namespace gt
