#include "modules/motion/head/HeadPathPlanner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gt {
namespace {

double distance(const HeadAngles& a, const HeadAngles& b) {
  return std::hypot(a.tilt - b.tilt, a.pan - b.pan, a.roll - b.roll);
}

TEST(HeadPathPlanner, ReachesTheLastPointInTimeAtOneSpeed) {
  const HeadAngles start{-0.5, 0.3, 0.1}, corner{0, 1.2, 0}, end{-0.2, -1, 0};
  HeadPathPlanner path;
  path.plan(start, {corner, end}, 800);
  const double length = distance(start, corner) + distance(corner, end);
  HeadAngles before = start;
  double nearest = 10;
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(path.finished());
    const auto now = path.next();
    EXPECT_LE(distance(before, now), length / 100 + 1e-9);  // less only where it cuts the corner
    nearest = std::min(nearest, distance(now, corner));
    before = now;
  }
  EXPECT_TRUE(path.finished());
  EXPECT_LT(distance(before, end), 1e-9);
  EXPECT_LT(nearest, length / 100);
  EXPECT_LT(distance(path.next(), end), 1e-9);
}

TEST(HeadPathPlanner, NoWayIsFinishedAtOnce) {
  HeadPathPlanner path;
  path.plan({0.1, 0.2, 0}, {{0.1, 0.2, 0}}, 500);
  EXPECT_TRUE(path.finished());
  EXPECT_NEAR(path.next().pan, 0.2, 1e-12);
}

}  // namespace
}  // namespace gt
