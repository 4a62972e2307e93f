#include "modules/perception/scanning/CameraImage.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnImage.h"

namespace gt {
namespace {

constexpr Pixel dark{40, 128, 128, 0};

/// White right of a place, black left of it.
class CameraImageTest : public testing::Test {
 protected:
  CameraImageTest() {
    image_.allocate();
    for (std::size_t y = 0; y < 256; y += 4)
      colors_.classes[ColorTable64::index(static_cast<std::uint8_t>(y), 128, 128)] =
          y > 120 ? ColorClass::white : ColorClass::black;
  }
  /// The pixel in which the edge lies has a color in between.
  void drawEdge(double x) {
    for (int row = 0; row < image_.info.height; ++row)
      for (int column = 0; column < image_.info.width; ++column) {
        const double share = std::clamp(column + 1 - x, 0., 1.);
        image_.at(column, row) = pixelOf(Vector3d{40 + 160 * share, 128, 128}, 0, random_);
      }
  }

  Image image_;
  ColorTable64 colors_;
  CameraMatrix matrix_ = cameraAt({0, 0, 180}, 0, -0.3, 0);
  Horizon horizon_;
  std::vector<ScanPath> paths_;
  CameraImage picture_{image_, colors_, matrix_, horizon_, &paths_};
  Random random_{1};
};

TEST_F(CameraImageTest, FindsAnEdgeToAFractionOfAPixel) {
  for (double x = 80; x < 82; x += 0.25) {
    drawEdge(x);
    const ColorEdge fromRight =
        picture_.findEdge({100.5, 60.5}, {-1, 0}, ColorSet{ColorClass::white}, 2);
    EXPECT_NEAR(fromRight.point.x(), x, 0.3);
    EXPECT_FALSE(fromRight.onBorder);
    const ColorEdge fromLeft =
        picture_.findEdge({60.5, 60.5}, {1, 0}, ColorSet{ColorClass::black}, 2);
    EXPECT_NEAR(fromLeft.point.x(), x, 0.3);
  }
  EXPECT_EQ(paths_.size(), 16u);
}

TEST_F(CameraImageTest, AGapIsAcceptedIfItIsSmallEnough) {
  drawEdge(0);
  for (int x = 90; x < 92; ++x) image_.at(x, 60) = dark;
  const auto edge = [&](int maxGap) {
    return picture_.findEdge({100.5, 60.5}, {-1, 0}, ColorSet{ColorClass::white}, maxGap);
  };
  EXPECT_NEAR(edge(1).point.x(), 92, 0.6);
  EXPECT_TRUE(edge(2).onBorder);
  EXPECT_LT(edge(2).point.x(), 1);
}

TEST_F(CameraImageTest, AColorIsInASetOrNot) {
  constexpr ColorSet set{ColorClass::green, ColorClass::gray};
  for (std::size_t c = 0; c < enumCount<ColorClass>; ++c) {
    const auto color = static_cast<ColorClass>(c);
    EXPECT_EQ(set.contains(color), color == ColorClass::green || color == ColorClass::gray);
  }
}

}  // namespace
}  // namespace gt
