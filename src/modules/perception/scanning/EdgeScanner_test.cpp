#include "modules/perception/scanning/EdgeScanner.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"

namespace gt {
namespace {

using EdgeScannerTest = DrawnBoxes;

TEST_F(EdgeScannerTest, LineAndBorderAheadAreToldApart) {
  isLine_ = [](double x, double) { return x > 800 && x < 825; };
  boxes_ = {{{1600, -3000, 0}, {1700, 3000, 100}, ColorClass::white},
            {{1700, -9000, 0}, {1800, 9000, 2000}, ColorClass::noColor}};
  for (const double pan : {-0.4, 0., 0.3})
    for (const double roll : {-0.2, 0., 0.2}) {
      look(pan, -0.25, roll);
      ASSERT_GE(lines_.points[EdgeType::line].size(), 6u);
      ASSERT_GE(lines_.points[EdgeType::border].size(), 6u);
      for (const Vector2d& p : lines_.points[EdgeType::line]) EXPECT_NEAR(p.x(), 812.5, 20);
      for (const Vector2d& p : lines_.points[EdgeType::border]) EXPECT_NEAR(p.x(), 1600, 60);
    }
}

TEST_F(EdgeScannerTest, LinesAlongTheViewAreMetByRows) {
  isLine_ = [](double, double y) { return y > 100 && y < 125; };
  look(0, -0.4);
  ASSERT_GE(lines_.points[EdgeType::line].size(), 3u);
  for (const Vector2d& p : lines_.points[EdgeType::line]) EXPECT_NEAR(p.y(), 112.5, 15);
  EXPECT_TRUE(lines_.points[EdgeType::border].empty());
}

TEST_F(EdgeScannerTest, AGoalsFootIsAnEdge) {
  boxes_ = {{{1200, -300, 0}, {1210, 300, 300}, ColorClass::skyblue}};
  look(0, -0.1);
  ASSERT_GE(lines_.points[EdgeType::skyblueGoal].size(), 6u);
  for (const Vector2d& p : lines_.points[EdgeType::skyblueGoal]) {
    EXPECT_NEAR(p.x(), 1200, 45);
    EXPECT_LT(std::abs(p.y()), 320);
  }
  EXPECT_TRUE(lines_.points[EdgeType::yellowGoal].empty());
}

TEST_F(EdgeScannerTest, AnEmptyCarpetHasNoEdges) {
  look(0.2, -0.3);
  for (const auto& points : lines_.points) EXPECT_TRUE(points.empty());
  for (const FreeGround& line : obstacles_.lines) EXPECT_GT(line.farPoint.norm(), 1500);
}

TEST_F(EdgeScannerTest, ASpeckIsNoLine) {
  for (double x = 500; x < 800; x += 20) {
    isLine_ = [&](double at, double y) { return at > x && at < x + 25 && y > 0 && y < 25; };
    look(0, -0.3);
    EXPECT_TRUE(lines_.points[EdgeType::line].empty()) << x;
  }
}

// A robot's white feet in front of its body look like a piece of the border.
TEST_F(EdgeScannerTest, AmongManyLinesAFewPointsAreNoBorder) {
  isLine_ = [](double x, double) { return x > 500 && x < 525; };
  boxes_ = {{{900, -90, 0}, {910, 90, 100}, ColorClass::white},
            {{910, -90, 0}, {1000, 90, 300}, ColorClass::gray}};
  look(0, -0.3);
  EXPECT_GE(lines_.points[EdgeType::line].size(), 15u);
  EXPECT_TRUE(lines_.points[EdgeType::border].empty());
}

/// A column of an image of stripes, each with a class and a brightness, 190 mm above the ground.
class BrightColumn : public testing::Test {
 protected:
  using enum ColorClass;
  struct Stripe {
    ColorClass color;
    int y, height;
  };

  BrightColumn() {
    image_.info = matrix_.info;
    image_.allocate();
    for (int c = 0; c < static_cast<int>(enumCount<ColorClass>); ++c)
      for (int y = 0; y < 256; y += 4)
        colors_.classes[ColorTable64::index(static_cast<std::uint8_t>(y),
                                            static_cast<std::uint8_t>(8 * c), 128)] =
            static_cast<ColorClass>(c);
    line_.start = {88.5, 0.5};
    line_.step = {0, 1};
    line_.length = image_.info.height;
  }
  /// The last stripe goes on to the end. Returns the edges found, three or more of a type.
  const std::vector<EdgeScanner::EdgePoint>& scan(const std::vector<Stripe>& stripes) {
    int row = 0;
    for (const Stripe& stripe : stripes)
      for (int i = 0; (i < stripe.height || &stripe == &stripes.back()) && row < line_.length;
           ++i, ++row)
        for (int x = 0; x < image_.info.width; ++x)
          image_.at(x, row) = {static_cast<std::uint8_t>(stripe.y),
                               static_cast<std::uint8_t>(8 * static_cast<int>(stripe.color)), 128,
                               0};
    const Horizon horizon = horizonOf(matrix_);
    const CameraImage picture{image_, colors_, matrix_, horizon};
    scanner_.clear();
    for (int i = 0; i < times_; ++i) scanner_.scanDown(picture, line_, FieldDimensions{});
    LinesPercept percept;
    scanner_.finish(percept);
    return scanner_.points();
  }

  int times_ = 3;
  CameraMatrix matrix_ = cameraAt({0, 0, 190}, 0, -0.4, 0);
  Image image_;
  ColorTable64 colors_;
  ScanLine line_;
  EdgeScanner scanner_;
};

TEST_F(BrightColumn, ALineIsInTheMiddleOfItsEdges) {
  for (int width = 3; width <= 5; ++width) {
    const auto& points = scan({{green, 80, 70}, {white, 180, width}, {green, 80, 1}});
    ASSERT_EQ(points.size(), 3u) << width;
    EXPECT_EQ(points[0].type, EdgeType::line);
    EXPECT_NEAR(points[0].inImage.y(), 70 + width / 2., 1e-9);
  }
  // Blurred: halfway between both brightnesses.
  const auto& blurred =
      scan({{green, 80, 70}, {white, 155, 1}, {white, 180, 3}, {white, 105, 1}, {green, 80, 1}});
  ASSERT_EQ(blurred.size(), 3u);
  EXPECT_NEAR(blurred[0].inImage.y(), 72.25, 0.15);
}

TEST_F(BrightColumn, ALineIsClearlyBrighterThanTheGreenAroundIt) {
  EXPECT_EQ(scan({{green, 80, 70}, {white, 105, 4}, {green, 80, 1}}).size(), 3u);
  EXPECT_EQ(scan({{green, 80, 70}, {white, 104, 4}, {green, 80, 1}}).size(), 0u);
  EXPECT_EQ(scan({{green, 80, 70}, {gray, 180, 4}, {green, 80, 1}}).size(), 0u);
  EXPECT_EQ(scan({{green, 80, 70}, {white, 180, 4}, {gray, 80, 1}}).size(), 0u);
  EXPECT_EQ(scan({{gray, 80, 70}, {white, 180, 4}, {green, 80, 1}}).size(), 0u);
}

// There a line is 5 pixels high, and the border 27.
TEST_F(BrightColumn, TheBorderIsHigherThanALineAndHasNoGreenBehindIt) {
  const auto& points = scan({{gray, 40, 50}, {white, 180, 25}, {green, 80, 1}});
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].type, EdgeType::border);
  EXPECT_NEAR(points[0].inImage.y(), 75, 1e-9) << "its foot";
  EXPECT_EQ(scan({{green, 80, 50}, {white, 180, 25}, {green, 80, 1}}).size(), 0u);
  EXPECT_EQ(scan({{gray, 40, 70}, {white, 180, 5}, {green, 80, 1}}).size(), 0u);
  EXPECT_EQ(scan({{white, 180, 75}, {green, 80, 1}}).size(), 3u) << "reaches beyond the image";
}

TEST_F(BrightColumn, FewerThanThreePointsOfATypeAreNoise) {
  times_ = 2;
  EXPECT_EQ(scan({{green, 80, 70}, {white, 180, 4}, {green, 80, 1}}).size(), 0u);
}

TEST_F(BrightColumn, ALineLiesOnTheGround) {
  const auto& points = scan({{green, 80, 70}, {white, 180, 4}, {green, 80, 1}});
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[0].onGround.x(), 190 / std::tan(0.4), 1e-6) << "on the optical axis";
  EXPECT_EQ(scan({{green, 80, 3}, {white, 180, 2}, {green, 80, 1}}).size(), 0u) << "horizon";
}

}  // namespace
}  // namespace gt
