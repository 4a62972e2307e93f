#include "modules/perception/scanning/ScanGrid.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gt
