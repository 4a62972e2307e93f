#include "modules/perception/specialists/SeenHeights.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gt
