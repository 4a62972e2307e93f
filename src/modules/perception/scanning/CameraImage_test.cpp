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

// Colors that grow evenly to the right and downwards are met exactly between pixel centers.
TEST_F(CameraImageTest, InterpolatesColors) {
  for (int row = 0; row < image_.info.height; ++row)
    for (int column = 0; column < image_.info.width; ++column)
      image_.at(column, row) = {static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row),
                                static_cast<std::uint8_t>((column + row) / 2), 0};
  for (const Vector2d& p : {Vector2d{80.5, 60.5}, {80.75, 60.5}, {80.5, 60.75}, {81.2, 61.9}}) {
    const Vector3d color = picture_.colorAt(p);
    EXPECT_NEAR(color[0], p.x() - 0.5, 1e-9);
    EXPECT_NEAR(color[1], p.y() - 0.5, 1e-9);
    EXPECT_NEAR(color[2], (p.x() + p.y() - 1) / 2, 0.5);
  }
  EXPECT_NEAR(picture_.colorAt({-5, -5})[0], 0, 1e-9);
  EXPECT_NEAR(picture_.colorAt({-5, -5})[1], 0, 1e-9);
  EXPECT_NEAR(picture_.colorAt({500, 500})[0], 175, 0.01) << "the last column";
  EXPECT_NEAR(picture_.colorAt({500, 500})[1], 143, 0.01);
}

TEST_F(CameraImageTest, FindsASharpEdgeBetweenPixelsExactly) {
  drawEdge(80);
  const auto white = ColorSet{ColorClass::white}, black = ColorSet{ColorClass::black};
  EXPECT_NEAR(picture_.findEdge({100.5, 60.5}, {-1, 0}, white, 2).point.x(), 80, 1e-9);
  EXPECT_NEAR(picture_.findEdge({60.5, 60.5}, {1, 0}, black, 2).point.x(), 80, 1e-9);
  EXPECT_NEAR(picture_.findEdge({80.5, 60.5}, {-1, 0}, white, 2).point.x(), 80, 1e-9)
      << "begins beside it";
  EXPECT_NEAR(picture_.findEdge({79.5, 60.5}, {1, 0}, black, 2).point.x(), 80, 1e-9);
  const Vector2d slanted = direction(0.3);
  EXPECT_NEAR(picture_.findEdge({60.5, 60.5}, slanted, black, 2).point.x(), 80, 0.1);
}

// Its class may end where hardly anything changes: the edge is half a pixel behind the last one.
TEST_F(CameraImageTest, AnEdgeWithoutContrastLiesBehindTheLastPixelOfItsClass) {
  for (int row = 0; row < image_.info.height; ++row)
    for (int column = 0; column < image_.info.width; ++column)
      image_.at(column, row).y = column < 80 ? 119 : 125;
  EXPECT_NEAR(picture_.findEdge({60.5, 60.5}, {1, 0}, ColorSet{ColorClass::black}, 2).point.x(), 80,
              1e-9);
  EXPECT_NEAR(picture_.findEdge({90.5, 60.5}, {-1, 0}, ColorSet{ColorClass::white}, 2).point.x(),
              80, 1e-9);
}

TEST_F(CameraImageTest, AColorEndsAtTheBorderIfItWasSeenNextToIt) {
  drawEdge(0);
  const auto edge = [&] {
    return picture_.findEdge({100.5, 60.5}, {-1, 0}, ColorSet{ColorClass::white}, 5);
  };
  EXPECT_TRUE(edge().onBorder);
  EXPECT_NEAR(edge().point.x(), 0.5, 1e-9);
  image_.at(0, 60) = dark;
  EXPECT_TRUE(edge().onBorder);
  image_.at(1, 60) = dark;
  EXPECT_FALSE(edge().onBorder);
}

// While the head turns each row has a rotation of its own.
TEST_F(CameraImageTest, ADirectionIsSeenWhereItsRowSawIt) {
  matrix_.info.rowTime = 0.23;
  matrix_.turning = {0.3, -1, 2};
  for (const Vector2d& p : {Vector2d{20, 10}, {88, 72}, {150, 140}})
    EXPECT_NEAR((picture_.pointOf(picture_.ray(p)) - p).norm(), 0, 0.1) << p.transpose();
}

}  // namespace
}  // namespace gt
