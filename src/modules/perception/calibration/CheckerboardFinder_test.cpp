#include "modules/perception/calibration/CheckerboardFinder.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnCheckerboard.h"

namespace gt {
namespace {

class CheckerboardTest : public testing::Test {
 protected:
  DrawnCheckerboard drawn_;
  Random random_{4};
  CheckerboardFinder finder_;
  std::vector<Vector2d> corners_;
};

TEST_F(CheckerboardTest, CornersAreFoundToAFractionOfAPixel) {
  for (int i = 0; i < 12; ++i) {
    const double distance = random_.uniform(450, 700);
    DrawnField scene{random_.uniform(-0.1, 0.05), random_.uniform(-0.15, 0.15)};
    scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, distance); }, 1, 2, random_);
    ASSERT_TRUE(finder_.find(scene.image, horizonOf(scene.matrix), drawn_.board, corners_))
        << distance;
    ASSERT_EQ(corners_.size(), 24u);
    for (int row = 0; row < drawn_.board.rows; ++row)
      for (int column = 0; column < drawn_.board.columns; ++column) {
        const Vector2d truth = pointIn(
            scene.matrix, drawn_.cornerAt(column, row, distance) - scene.matrix.pose.translation);
        const Vector2d& seen =
            corners_[static_cast<std::size_t>(row * drawn_.board.columns + column)];
        EXPECT_LT((truth - seen).norm(), 0.35) << row << " " << column;
      }
  }
}

TEST_F(CheckerboardTest, IsNotFoundWhereItIsNotOrNotWhole) {
  DrawnField scene{0};
  scene.draw(fieldAt, 1, 10, random_);
  EXPECT_FALSE(finder_.find(scene.image, horizonOf(scene.matrix), drawn_.board, corners_));
  scene.matrix.pose.rotation = rotationZ(0.45);
  scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, 500); }, 1, 2, random_);
  EXPECT_FALSE(finder_.find(scene.image, horizonOf(scene.matrix), drawn_.board, corners_));
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 100}, {100, 3}}) {
    Image tiny;
    tiny.info.width = width;
    tiny.info.height = height;
    tiny.allocate();
    EXPECT_FALSE(finder_.find(tiny, Horizon{}, drawn_.board, corners_));
  }
}

}  // namespace
}  // namespace gt
