#include "modules/perception/scanning/FieldView.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modules/perception/scanning/Horizon.h"

namespace gt {
namespace {

/// Sizes are measured where the camera looks: there a pixel is an angle of 1 / focal length.
TEST(FieldView, LinesAndBordersAreAsLongAsTheAnglesToTheirEnds) {
  const Image image;
  const ColorTable64 colors;
  const FieldDimensions field;
  CameraMatrix matrix;
  for (const double height : {90.0, 180.0, 250.0}) {
    matrix.pose.translation = {60, 10, height};
    const Horizon horizon = horizonOf(matrix);
    const CameraImage picture{image, colors, matrix, horizon};
    const double focal = matrix.info.focalX;
    for (const double distance : {50.0, 300.0, 1000.0, 4000.0}) {
      const double down = std::atan(height / distance);
      EXPECT_NEAR(expectedLineWidth(picture, distance, field),
                  focal * (down - std::atan(height / (distance + field.lineWidth))), 1e-9);
      EXPECT_NEAR(expectedBorderHeight(picture, distance, field),
                  focal * (down - std::atan((height - field.wallHeight) / distance)), 1e-9);
    }
  }
}

TEST(FieldView, WhatIsSeenOfTheGroundLiesWhereItIs) {
  const Image image;
  const ColorTable64 colors;
  CameraMatrix matrix;
  matrix.pose.translation = {60, 10, 180};
  const Horizon horizon = horizonOf(matrix);
  const CameraImage picture{image, colors, matrix, horizon};
  for (const Vector2d& place : {Vector2d{700, 0}, Vector2d{1500, 400}, Vector2d{3000, -900}}) {
    const Vector3d ray = Vector3d{place.x(), place.y(), 0} - matrix.pose.translation;
    const auto found = onGround(picture, picture.pointOf(ray));
    ASSERT_TRUE(found) << place;
    EXPECT_LT((*found - place).norm(), 1e-6) << place;
  }
  EXPECT_FALSE(onGround(picture, picture.pointOf({1, 0, 0.1}))) << "above the horizon";
  EXPECT_FALSE(onGround(picture, picture.pointOf({9000, 0, -180}))) << "beyond any field";
}

}  // namespace
}  // namespace gt
