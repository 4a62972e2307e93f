#include "modules/perception/Horizon.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/perception/ScanGrid.h"

namespace gt {
namespace {

CameraMatrix someMatrix(Random& random) {
  CameraMatrix matrix;
  matrix.pose.rotation = rotationZ(random.uniform(-pi, pi)) * rotationY(random.uniform(-0.5, 1.3)) *
                         rotationX(random.uniform(-0.5, 0.5));
  matrix.pose.translation = {80, 0, 170};
  return matrix;
}

// Points of the field's plane at infinity, projected, must lie on the horizon.
TEST(Horizon, HoldsWhatIsFarAway) {
  Random random{1};
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    const CameraMatrix matrix = someMatrix(random);
    const Horizon horizon = horizonOf(matrix);
    const Vector2d way = direction(random.uniform(-pi, pi));
    const Vector3d inCamera = matrix.pose.rotation.transpose() * Vector3d{way.x(), way.y(), 0};
    if (inCamera.x() < 0.1) continue;
    ++seen;
    EXPECT_NEAR(horizon.fromPicture(matrix.info.project(inCamera)).y(), 0, 1e-6);
    // Below the horizon is where the ground is.
    const Vector2d below = horizon.toPicture(10, 5);
    EXPECT_LT((matrix.pose.rotation * matrix.info.ray(below.x(), below.y())).z(), 0);
  }
  EXPECT_GT(seen, 50);
}

// The report's formulas 3.5 and 3.6 for the left and the right border, where the focal lengths are
// the same and the axis meets the middle.
TEST(Horizon, FollowsTheReportsFormula) {
  Random random{2};
  for (int i = 0; i < 50; ++i) {
    CameraMatrix matrix = someMatrix(random);
    matrix.info.focalX = matrix.info.focalY = 160;
    const Matrix3d r = matrix.pose.rotation.transpose();  // Robot to camera, as in the report.
    const double s = 88, cot = 160 / s;
    // i = R^T h with z = 0: the third column of R takes the place of the printed third row.
    const double left = -(r(1, 2) * s + r(0, 2) * s * cot) / r(2, 2);
    const double right = -(-r(1, 2) * s + r(0, 2) * s * cot) / r(2, 2);
    const Horizon horizon = horizonOf(matrix);
    EXPECT_NEAR(horizon.fromPicture({0, 72 - left}).y(), 0, 1e-6);
    EXPECT_NEAR(horizon.fromPicture({176, 72 - right}).y(), 0, 1e-6);
  }
}

TEST(Horizon, ExistsForEveryRotation) {
  CameraMatrix matrix;
  for (const double tilt : {-pi / 2, pi / 2, pi}) {
    matrix.pose.rotation = rotationY(tilt);
    const Horizon horizon = horizonOf(matrix);
    EXPECT_TRUE(horizon.base.allFinite());
    EXPECT_NEAR(horizon.down.norm(), 1, 1e-9);
    ScanGrid grid;
    grid.build(matrix.info, horizon, {});
    EXPECT_FALSE(grid.lines().empty());
  }
}

// No line leaves the picture, and near the horizon they are as dense as asked for.
TEST(ScanGrid, StaysInThePictureAndIsDenseAtTheHorizon) {
  Random random{3};
  ScanGrid grid;
  for (int i = 0; i < 300; ++i) {
    const CameraMatrix matrix = someMatrix(random);
    const Horizon horizon = horizonOf(matrix);
    grid.build(matrix.info, horizon, {});
    for (const ScanLine& line : grid.lines())
      for (const int k : {0, line.length / 2, line.length - 1}) {
        const Vector2d p = line.at(k);
        ASSERT_TRUE(matrix.info.contains(p.x(), p.y())) << p.transpose();
      }
  }
  CameraMatrix level;
  grid.build(level.info, horizonOf(level), {});
  int crossing = 0, bottom = 0;
  for (const ScanLine& line : grid.lines()) {
    const double end = line.at(line.length - 1).y();
    if (line.start.y() < 72 && end > 73) ++crossing;
    if (end > 140) ++bottom;
  }
  EXPECT_NEAR(crossing, 176 / 2, 2);
  EXPECT_NEAR(bottom, 176 / 8, 2);
}

}  // namespace
}  // namespace gt
