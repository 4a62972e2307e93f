#include "modules/perception/scanning/Horizon.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/perception/scanning/ScanGrid.h"

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
    EXPECT_NEAR(horizon.fromImage(matrix.info.project(inCamera)).y(), 0, 1e-6);
    // Below the horizon is where the ground is.
    const Vector2d below = horizon.toPicture(10, 5);
    EXPECT_LT((matrix.pose.rotation * matrix.info.ray(below.x(), below.y())).z(), 0);
  }
  EXPECT_GT(seen, 50);
}

// With a lens that bends it, the horizon is that next to the optical axis.
TEST(Horizon, FollowsTheLens) {
  Random random{6};
  for (int i = 0; i < 50; ++i) {
    CameraMatrix matrix = someMatrix(random);
    matrix.info.distortion2 = -0.2;
    const Horizon horizon = horizonOf(matrix);
    if (!matrix.info.contains(horizon.base.x(), horizon.base.y())) continue;
    const auto up = [&](double u) {
      const Vector2d p = horizon.toPicture(u, 0);
      return (matrix.pose.rotation * matrix.info.ray(p.x(), p.y()).normalized()).z();
    };
    EXPECT_NEAR(up(0), 0, 1e-9);
    EXPECT_NEAR(up(0.5), up(-0.5), 1e-5) << "it is bent the same to both sides";
  }
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
    EXPECT_NEAR(horizon.fromImage({0, 72 - left}).y(), 0, 1e-6);
    EXPECT_NEAR(horizon.fromImage({176, 72 - right}).y(), 0, 1e-6);
  }
}

TEST(CameraInfo, UndoesTheLens) {
  for (const auto& [k2, k4] :
       {std::pair{-0.2, 0.0}, {-0.25, 0.08}, {0.1, 0.0}, {-1.0, 0.3}, {-1.0, 1.0}, {0.3, -1.0}}) {
    CameraInfo info;
    info.distortion2 = k2;
    info.distortion4 = k4;
    double before = -1;
    for (double r = 0; r < 3; r += 0.01) {
      const double seen = r * info.distortion().factor(r * r);
      EXPECT_GT(seen, before) << "no direction is seen twice: " << k2 << " " << r;
      before = seen;
      EXPECT_NEAR(seen * info.distortion().undoing(seen * seen), r, 1e-3) << k2 << " " << k4;
    }
    const Vector2d pixel{20.5, 130.25};
    const Vector2d again = info.project(2.5 * info.ray(pixel.x(), pixel.y()));
    EXPECT_NEAR((again - pixel).norm(), 0, 1e-2) << k2 << " " << k4;
  }
  // A barrel distortion sees more than follows from the focal length.
  CameraInfo barrel;
  barrel.distortion2 = -0.2;
  EXPECT_GT(barrel.openingAngleX(), CameraInfo{}.openingAngleX() + 0.02);
  EXPECT_NEAR(CameraInfo{}.openingAngleX(), 57.6 * pi / 180, 1e-3);
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

// No line leaves the image, and near the horizon they are as dense as asked for.
TEST(ScanGrid, StaysInTheImageAndIsDenseAtTheHorizon) {
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
