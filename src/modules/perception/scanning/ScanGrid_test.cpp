#include "modules/perception/scanning/ScanGrid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/Random.h"

namespace gt {
namespace {

TEST(ScanGrid, EveryPixelOfEveryLineLiesInTheImage) {
  Random random{1};
  ScanGrid grid;
  for (int i = 0; i < 300; ++i) {
    CameraInfo info;
    info.width = 1 + static_cast<int>(random.index(200));
    info.height = 1 + static_cast<int>(random.index(150));
    Horizon horizon;
    horizon.base = {random.uniform(-100, 300), random.uniform(-200, 300)};
    horizon.along = direction(random.uniform(-pi, pi));
    horizon.down = rotated(horizon.along, pi / 2);
    grid.build(info, horizon, {});
    for (const auto* lines : {&grid.lines(), &grid.rows()})
      for (const ScanLine& line : *lines)
        for (int k = 0; k < line.length; ++k)
          ASSERT_TRUE(info.contains(line.at(k).x(), line.at(k).y()));
  }
}

TEST(ScanGrid, IsDenseNextToTheHorizonAndCoarseBelow) {
  const CameraInfo info;
  Horizon horizon;
  horizon.base = {info.width / 2.0, 20};
  ScanGrid grid;
  grid.build(info, horizon, {.dense = 2, .reachUp = 5, .reachDown = 8});
  const auto crossing = [&](double y) {
    int count = 0;
    for (const ScanLine& line : grid.lines())
      count += line.start.y() <= y && line.at(line.length - 1).y() >= y;
    return count;
  };
  EXPECT_NEAR(crossing(25), info.width / 2, 2);   // each of them
  EXPECT_NEAR(crossing(45), info.width / 4, 2);   // 25 pixels below only the coarser ones
  EXPECT_NEAR(crossing(100), info.width / 8, 2);  // those over the whole image
  double last = -1e9;
  for (const ScanLine& line : grid.lines()) {
    EXPECT_GT(line.u, last) << "from left to right";
    last = line.u;
    EXPECT_EQ(line.whole, line.toBorder && line.fromBorder);
    EXPECT_GT(line.step.y(), 0) << "from top to bottom";
  }
}

TEST(ScanGrid, CountsTheStepsToTheBorder) {
  const CameraInfo info;
  Random random{1};
  for (int i = 0; i < 1000; ++i) {
    const Vector2d start{random.uniform(0, info.width), random.uniform(0, info.height)};
    const Vector2d step = direction(random.uniform(-pi, pi));
    const int steps = stepsInImage(info, start, step);
    int expected = 0;
    for (Vector2d p = start; info.contains(p.x(), p.y()); p += step) ++expected;
    EXPECT_GE(steps, expected - 1) << start.transpose() << ", " << step.transpose();
    EXPECT_LE(steps, expected) << start.transpose() << ", " << step.transpose();
  }
  EXPECT_EQ(stepsInImage(info, {-1, 10}, {1, 0}), 0) << "from outside";
  EXPECT_EQ(stepsInImage(info, {0.5, 10}, {1, 0}), info.width);
  EXPECT_EQ(stepsInImage(info, {0.5, 10}, {-1, 0}), 1);
}

TEST(ScanGrid, WalksOverThePixelsOfALine) {
  Image image;
  image.allocate();
  Horizon horizon;
  horizon.base = {80, 40};
  horizon.along = direction(0.3);
  horizon.down = rotated(horizon.along, pi / 2);
  ScanGrid grid;
  grid.build(image.info, horizon, {});
  ASSERT_FALSE(grid.lines().empty());
  for (const ScanLine& line : grid.lines()) {
    PixelWalk walk{image, line};
    for (int k = 0; k < line.length; ++k, walk.step()) {
      const Vector2d p = line.at(k);
      const auto at = &walk.pixel() - image.pixels.data();
      EXPECT_NEAR(static_cast<double>(at % image.info.width), std::floor(p.x()), 1);
      EXPECT_NEAR(static_cast<double>(at / image.info.width), std::floor(p.y()), 1);
    }
  }
}

// What is bright on one side of an edge is met in both orders.
TEST(ScanGrid, RowsAlternateInDirection) {
  const CameraInfo info;
  Horizon horizon;
  horizon.base = {info.width / 2.0, 0};
  ScanGrid grid;
  grid.build(info, horizon, {});
  ASSERT_GE(grid.rows().size(), 4u);
  for (std::size_t i = 0; i + 1 < grid.rows().size(); ++i) {
    EXPECT_EQ(grid.rows()[i].step, -grid.rows()[i + 1].step);
    EXPECT_LT(grid.rows()[i].start.y(), grid.rows()[i + 1].start.y());
  }
}

// Counted one by one: the centers of pixels along the axis that is closer, between low and high.
TEST(ClippedLine, HasAllPixelsOfItsPartOfTheImage) {
  const CameraInfo info;
  Random random{1};
  for (int i = 0; i < 500; ++i) {
    const Vector2d base{random.uniform(-50, 250), random.uniform(-50, 200)};
    const Vector2d way = direction(random.uniform(-pi, pi));
    const double low = random.uniform(-200, 50), high = low + random.uniform(10, 300);
    const ScanLine line = clippedLine(info, base, way, low, high);
    const int major = std::abs(way.x()) > std::abs(way.y()) ? 0 : 1;
    int pixels = 0;
    for (int k = 0; k < (major == 0 ? info.width : info.height); ++k) {
      const double t = (k + 0.5 - base[major]) / way[major];
      const Vector2d p = base + t * way;
      pixels += t >= low && t <= high && info.contains(p.x(), p.y()) ? 1 : 0;
    }
    EXPECT_EQ(line.length, pixels) << i;
    if (line.length == 0) continue;
    EXPECT_NEAR(std::abs(line.step[major]), 1, 1e-12);
    EXPECT_GT(line.step.dot(way), 0);
    for (int k = 0; k < line.length; ++k) {
      const Vector2d p = line.at(k) - base;
      EXPECT_NEAR(p.x() * way.y() - p.y() * way.x(), 0, 1e-9);
      EXPECT_NEAR(line.at(k)[major] - std::floor(line.at(k)[major]), 0.5, 1e-9);
    }
    const Vector2d from = base + low * way, to = base + high * way;
    EXPECT_EQ(line.fromBorder, !info.contains(from.x(), from.y())) << i;
    EXPECT_EQ(line.toBorder, !info.contains(to.x(), to.y())) << i;
  }
}

TEST(ClippedLine, AlongAnAxisIsEmptyBesideTheImage) {
  const CameraInfo info;
  for (const auto& [at, inside] :
       {std::pair{-0.1, false}, {0., true}, {143.9, true}, {144., false}})
    EXPECT_EQ(clippedLine(info, {10, at}, {1, 0}, 0, 50).length, inside ? 50 : 0) << at;
  for (const auto& [at, inside] :
       {std::pair{-0.1, false}, {0., true}, {175.9, true}, {176., false}})
    EXPECT_EQ(clippedLine(info, {at, 10}, {0, 1}, 0, 50).length, inside ? 50 : 0) << at;
  EXPECT_EQ(clippedLine(info, {10, 10}, {1, 0}, 5, 5).length, 0);
}

// Finer lines end at so many times their spacing above and below the horizon.
TEST(ScanGrid, FinerLinesReachAsFarAsTheirSpacingSays) {
  const CameraInfo info;
  Horizon horizon;
  horizon.base = {info.width / 2., info.height / 2.};
  ScanGrid grid;
  grid.build(info, horizon, {.dense = 3, .reachUp = 4, .reachDown = 7});
  int whole = 0, middle = 0, fine = 0;
  for (std::size_t i = 0; i < grid.lines().size(); ++i) {
    const ScanLine& line = grid.lines()[i];
    const double top = line.start.y() - 0.5, bottom = line.at(line.length).y() - 0.5;
    EXPECT_NEAR(line.start.x(), line.u + horizon.base.x(), 1e-9);
    if (i > 0) {
      EXPECT_NEAR(line.u - grid.lines()[i - 1].u, 3, 1e-9);
    }
    if (line.whole) {
      ++whole;
      EXPECT_EQ(line.length, info.height);
    } else {
      const double spacing = bottom > 72 + 5 * 7 ? 6 : 3;
      ++(spacing == 6 ? middle : fine);
      EXPECT_NEAR(top, 72 - 4 * spacing, 1);
      EXPECT_NEAR(bottom, 72 + 7 * spacing, 1);
    }
  }
  EXPECT_NEAR(whole, 176. / 12, 1);
  EXPECT_NEAR(middle, 176. / 12, 1);
  EXPECT_NEAR(fine, 176. / 6, 1);
}

TEST(ScanGrid, RowsBelowTheHorizonGetRarer) {
  const CameraInfo info;
  Horizon horizon;
  horizon.base = {info.width / 2., 20};
  ScanGrid grid;
  grid.build(info, horizon, {.dense = 2});
  ASSERT_EQ(grid.rows().size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const ScanLine& row = grid.rows()[i];
    EXPECT_EQ(row.length, info.width);
    EXPECT_NEAR(row.start.y() - 20, 10 * std::pow(1.7, i), 1e-9);
  }
}

}  // namespace
}  // namespace gt
