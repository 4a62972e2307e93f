#include "modules/perception/specialists/FlagSpecialist.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"
#include "modules/perception/testing/DrawnLandmarks.h"

namespace gt {
namespace {

using FlagSpecialistTest = DrawnLandmarks;

/// Boards in the colors of flags, which are as wide and as high as a flag's.
class LikeAFlag : public DrawnBoxes {
 protected:
  static constexpr double x = 1500, half = 50, middle = 310;

  static Box board(double bottom, double top, ColorClass color, double halfWidth = half) {
    return {{x, -halfWidth, bottom}, {x + 10, halfWidth, top}, color};
  }
  static Box pole(double higher = 0) { return board(0, 210 + higher, ColorClass::white); }
  int flags() {
    look(0, 0.1);
    return percepts_.landmarks.numberOfFlags;
  }
};

TEST_F(FlagSpecialistTest, MeasuresEachFlag) {
  random_ = Random{8};
  for (int i = 0; i < 30; ++i) {
    flagType_ = static_cast<FlagType>(i % 6);
    flag_ = direction(random_.uniform(-0.3, 0.3)) * random_.uniform(800, 3200);
    look(random_.uniform(-0.2, 0.2), random_.uniform(-0.1, 0.1), random_.uniform(-0.2, 0.2));
    const Vector2d to = *flag_ - camera().head<2>();
    const double half = std::asin(field_.flagRadius / to.norm());
    ASSERT_EQ(landmarks_.numberOfFlags, 1) << enumName(flagType_) << " " << flag_->transpose();
    const FlagPercept& seen = landmarks_.flags[0];
    EXPECT_EQ(seen.type, flagType_);
    if (!seen.boundary.leftOnBorder) {
      EXPECT_NEAR(seen.boundary.left, angleOf(to) + half, fromDegrees(0.3));
    }
    if (!seen.boundary.rightOnBorder) {
      EXPECT_NEAR(seen.boundary.right, angleOf(to) - half, fromDegrees(0.3));
    }
    EXPECT_NEAR(seen.distance / flag_->norm(), 1, 0.06);
    EXPECT_NEAR(seen.angle, angleOf(*flag_), fromDegrees(0.5));
  }
}

TEST_F(FlagSpecialistTest, TellsAFlagsEdgeThatIsNotInTheImage) {
  random_ = Random{9};
  flag_ = Vector2d{1200, 0};
  look(image_.info.openingAngleX() / 2 - 0.01, 0.05, 0);
  ASSERT_EQ(landmarks_.numberOfFlags, 1);
  const ConditionalBoundary& b = landmarks_.flags[0].boundary;
  EXPECT_TRUE(b.rightOnBorder);
  EXPECT_FALSE(b.leftOnBorder || b.topOnBorder || b.bottomOnBorder);
  EXPECT_NEAR(landmarks_.flags[0].angle, 0, fromDegrees(0.5));
}

TEST_F(LikeAFlag, StandsAtItsHeight) {
  for (const double higher : {0., 450.}) {
    boxes_ = {pole(higher), board(210 + higher, middle + higher, ColorClass::yellow),
              board(middle + higher, 410 + higher, ColorClass::pink)};
    EXPECT_EQ(flags(), higher == 0) << higher;
  }
}

TEST_F(LikeAFlag, HasTwoFieldsOfTheSameWidth) {
  for (const double halfWidth : {half, half / 5}) {
    boxes_ = {pole(), board(210, middle, ColorClass::green, halfWidth),
              board(middle, 410, ColorClass::pink)};
    EXPECT_EQ(flags(), halfWidth == half) << "a square on a pole of " << 2 * halfWidth << " mm";
  }
}

// Pink between two colors belongs to the flag that stands on its pole, not on another color.
TEST_F(LikeAFlag, IsTheOneThatStandsOnItsPole) {
  boxes_ = {board(210, middle, ColorClass::skyblue), board(middle, 410, ColorClass::pink),
            board(410, 510, ColorClass::yellow)};
  EXPECT_EQ(flags(), 0) << "on green";
  boxes_.push_back(pole());
  ASSERT_EQ(flags(), 1);
  EXPECT_EQ(percepts_.landmarks.flags[0].type, FlagType::pinkAboveSkyblue);
}

TEST_F(LikeAFlag, SomebodyBehindItInItsUpperColorIsNoPartOfIt) {
  for (const bool pinkAbove : {false, true}) {
    const ColorClass upper = pinkAbove ? ColorClass::pink : ColorClass::yellow;
    boxes_ = {pole(),
              board(210, middle, pinkAbove ? ColorClass::yellow : ColorClass::pink),
              board(middle, 410, upper),
              {{2200, -250, 300}, {2300, 120, 1000}, upper}};
    ASSERT_EQ(flags(), 1) << enumName(upper);
    const FlagPercept& flag = percepts_.landmarks.flags[0];
    EXPECT_EQ(flag.type, pinkAbove ? FlagType::pinkAboveYellow : FlagType::yellowAbovePink);
    EXPECT_NEAR(toDegrees(flag.angle), 0, 1);
    EXPECT_NEAR(flag.distance, x, 150);
  }
}

}  // namespace
}  // namespace gt
