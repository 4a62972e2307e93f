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

}  // namespace
}  // namespace gt
