#include "modules/perception/specialists/SeenHeights.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gt {
namespace {

constexpr double tooHigh = fromDegrees(1), distance = 1800;

/// A flag that is seen too high, by a level camera.
class SeenHeights : public testing::Test {
 protected:
  SeenHeights() { matrix_.pose.translation = {0, 0, 190}; }

  FlagPercept flag() const {
    const auto seen = [&](double z) {
      return std::atan2(z - matrix_.pose.translation.z(), distance) + tooHigh;
    };
    FlagPercept flag;
    flag.boundary = {.left = 0.42,
                     .right = 0.38,
                     .top = seen(field_.flagTop),
                     .bottom = seen(field_.flagBottom)};
    return flag;
  }

  FieldDimensions field_;
  CameraMatrix matrix_;
};

TEST_F(SeenHeights, OfAFlagIsBesideThatOfItsDistance) {
  const auto height = heightOf(flag(), matrix_, field_);
  ASSERT_TRUE(height);
  EXPECT_NEAR(height->azimuth, 0.4, 1e-9);
  EXPECT_NEAR(height->tooHigh, tooHigh, fromDegrees(0.05));
  EXPECT_NEAR(height->distance, distance, 20);
  EXPECT_NEAR(height->deviation, fromDegrees(0.2), fromDegrees(0.1)) << "half a pixel";
}

TEST_F(SeenHeights, NeedsBothEnds) {
  FlagPercept cut = flag();
  cut.boundary.topOnBorder = true;
  EXPECT_FALSE(heightOf(cut, matrix_, field_));
  cut = flag();
  cut.boundary.bottom = cut.boundary.top;
  EXPECT_FALSE(heightOf(cut, matrix_, field_)) << "it has no height";
}

// What a camera that looks too high, or is believed too high, sees is mended by turning or lifting.
TEST_F(SeenHeights, TellsWhatMendsIt) {
  const double before = heightOf(flag(), matrix_, field_)->tooHigh;
  const Vector3d mended = heightOf(flag(), matrix_, field_)->mended();
  const FlagPercept seen = flag();
  matrix_.pose.translation.z() += 20;
  EXPECT_NEAR(heightOf(seen, matrix_, field_)->tooHigh, before - 20 * mended.z(), 1e-4);
}

TEST_F(SeenHeights, AreThoseOfAllThatIsSeen) {
  LandmarksPercept landmarks;
  landmarks.numberOfFlags = 1;
  landmarks.flags[0] = flag();
  std::vector<SeenHeight> heights(3);
  takeHeights(matrix_, {}, landmarks, field_, heights);
  ASSERT_EQ(heights.size(), 1u);
  EXPECT_EQ(heights[0].tooHigh, heightOf(flag(), matrix_, field_)->tooHigh);
}

/// A ball whose size is right, seen too high: its projection lies too far away.
class SeenHeightOfBall : public SeenHeights {
 protected:
  static constexpr double away = 800;
  BallPercept ball_;
  double down_ = 0;  ///< To its center, truly.

  SeenHeightOfBall() {
    const double lower = matrix_.pose.translation.z() - field_.ballRadius;
    down_ = std::asin(lower / away);
    ball_.seen = true;
    ball_.angle = {0.2, -down_};
    ball_.distanceBySize = away;
    ball_.distanceByProjection = lower / std::sin(down_ - tooHigh);
    ball_.centerInImage = {88, 72};
    ball_.radiusInImage = 9;
  }
  std::vector<SeenHeight> heights() const {
    std::vector<SeenHeight> heights;
    takeHeights(matrix_, ball_, {}, field_, heights);
    return heights;
  }
};

TEST_F(SeenHeightOfBall, IsThatOfItsProjectionAgainstItsSize) {
  ASSERT_EQ(heights().size(), 1u);
  const SeenHeight height = heights()[0];
  EXPECT_NEAR(height.azimuth, 0.2, 1e-9);
  EXPECT_NEAR(height.tooHigh, tooHigh, 1e-9);
  EXPECT_NEAR(height.distance, away * std::cos(down_), 1e-6) << "along the ground";
  // Of the radius 3 % and 0.3 of 9 pixels: so much of the distance, and of the slope.
  EXPECT_NEAR(height.deviation, 0.045 * std::tan(down_), 0.001);
}

TEST_F(SeenHeightOfBall, NeedsAWholeBallAndBothDistances) {
  for (const Vector2d& center : {Vector2d{8, 72}, {168, 72}, {88, 8}, {88, 136}}) {
    ball_.centerInImage = center;
    EXPECT_TRUE(heights().empty()) << center.transpose();
  }
  for (const Vector2d& center : {Vector2d{10, 72}, {166, 72}, {88, 10}, {88, 134}}) {
    ball_.centerInImage = center;
    EXPECT_EQ(heights().size(), 1u) << center.transpose();
  }
  const BallPercept whole = ball_;
  ball_.seen = false;
  EXPECT_TRUE(heights().empty());
  ball_ = whole;
  ball_.distanceBySize = 0;
  EXPECT_TRUE(heights().empty());
  ball_ = whole;
  ball_.distanceByProjection = 0;
  EXPECT_TRUE(heights().empty());
  ball_ = whole;
  ball_.distanceBySize = matrix_.pose.translation.z() - field_.ballRadius - 1;
  EXPECT_TRUE(heights().empty()) << "nearer than right below the camera";
}

TEST_F(SeenHeights, OfAGoalIsThatOfItsMiddle) {
  const auto seen = [&](double z) {
    return std::atan2(z - matrix_.pose.translation.z(), distance) + tooHigh;
  };
  LandmarksPercept landmarks;
  landmarks.numberOfGoals = 1;
  landmarks.goals[0].boundary = {
      .left = 0.1, .right = -0.3, .top = seen(field_.goalHeight), .bottom = seen(0)};
  std::vector<SeenHeight> heights;
  takeHeights(matrix_, {}, landmarks, field_, heights);
  ASSERT_EQ(heights.size(), 1u);
  EXPECT_NEAR(heights[0].azimuth, -0.1, 1e-9);
  EXPECT_NEAR(heights[0].tooHigh, tooHigh, fromDegrees(0.05));
  EXPECT_NEAR(heights[0].distance, distance, 20);
  EXPECT_NEAR(heights[0].deviation, 1.5 / 160, 0.001) << "1.5 pixels of its foot";
}

}  // namespace
}  // namespace gt
