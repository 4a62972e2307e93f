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

TEST_F(CheckerboardTest, EachCornerIsACandidateOfATurnedBoard) {
  for (const double distance : {420., 550., 700.})
    for (const double roll : {-0.4, 0., 0.3}) {
      DrawnField scene{-0.05, roll};
      scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, distance); }, 1, 0, random_);
      ASSERT_TRUE(finder_.find(scene.image, horizonOf(scene.matrix), drawn_.board, corners_));
      EXPECT_EQ(finder_.candidates().size(), 24u) << "one for each corner";
      for (int i = 0; i < 24; ++i) {
        const Vector3d corner = drawn_.cornerAt(i % 6, i / 6, distance);
        const Vector2d truth = pointIn(scene.matrix, corner - scene.matrix.pose.translation);
        EXPECT_LT((truth - corners_[static_cast<std::size_t>(i)]).norm(), 0.35) << i;
      }
    }
}

TEST_F(CheckerboardTest, HasAsManyColumnsAndRowsAsTheBoard) {
  DrawnField scene{-0.05};
  scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, 550); }, 1, 0, random_);
  const Horizon horizon = horizonOf(scene.matrix);
  for (const auto& [columns, rows, found] : {std::tuple{6, 4, true},
                                             {4, 6, false},
                                             {8, 3, false},
                                             {3, 8, false},
                                             {6, 3, false},
                                             {7, 4, false}}) {
    Checkerboard board = drawn_.board;
    board.columns = columns;
    board.rows = rows;
    EXPECT_EQ(finder_.find(scene.image, horizon, board, corners_), found) << columns << rows;
  }
}

// In weak light its squares differ less.
TEST_F(CheckerboardTest, IsFoundInWeakLightAndNotWithoutContrast) {
  for (const auto& [light, found] : {std::pair{0.25, true}, {0.05, false}}) {
    DrawnField scene{-0.05};
    scene.draw([&](const Vector3d& ray) { return drawn_.colorAt(ray, 550); }, light, 0, random_);
    EXPECT_EQ(finder_.find(scene.image, horizonOf(scene.matrix), drawn_.board, corners_), found)
        << light;
  }
}

// A white spot, a line, an edge and a corner of something dark.
TEST_F(CheckerboardTest, OnlyWhereSquaresMeetIsACorner) {
  Image image;
  image.allocate();
  for (int y = 0; y < image.info.height; ++y)
    for (int x = 0; x < image.info.width; ++x) {
      const bool spot = std::abs(x - 30) < 3 && std::abs(y - 30) < 3;
      const bool line = std::abs(x + y - 150) < 3;
      const bool edge = x > 120;
      const bool corner = x > 140 && y > 100;
      const bool ends = x > 60 && x < 70 && y > 100;
      image.at(x, y).y = spot || line || corner || ends ? 230 : edge ? 130 : 20;
    }
  Checkerboard small;
  small.columns = small.rows = 2;
  EXPECT_FALSE(finder_.find(image, Horizon{}, small, corners_));
  for (const Vector2d& candidate : finder_.candidates()) {
    EXPECT_LT(std::abs(candidate.x() + candidate.y() - 150), 12)
        << "where the line crosses the others: " << candidate.transpose();
  }
}

}  // namespace
}  // namespace gt
