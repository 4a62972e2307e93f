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

// Where a goal and a red robot before it meet, their edge blurs into what looks pink.
TEST_F(LikeAFlag, PaleRedAboveARobotIsNotItsPink) {
  const Pixel mixed{100, 118, 165};
  for (const bool pink : {true, false}) {
    boxes_ = {board(middle, 410, ColorClass::yellow),
              board(210, middle, pink ? ColorClass::pink : ColorClass::orange),
              board(0, 210, ColorClass::red, 3 * half)};
    look(0, 0.1);
    for (Pixel& p : image_.pixels)
      if (colors_[p] == ColorClass::orange) p = mixed;
    colors_.classes[ColorTable64::index(mixed.y, mixed.cb, mixed.cr)] = ColorClass::pink;
    percepts_.lookWith(processor_, image_, matrix_, colors_, field_);
    EXPECT_EQ(percepts_.landmarks.numberOfFlags, pink);
  }
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

/// A flag's boundary as it follows from its size, seen from a camera that is not in the middle of
/// the robot.
class LocateFlag : public testing::Test {
 protected:
  static constexpr double height = 190;
  FieldDimensions field_;
  CameraMatrix matrix_ = cameraAt({60, 20, height}, 0, 0, 0);
  FlagPercept flag_;

  /// Elevation of what is that high on the side that faces the camera.
  double seen(double z, double distance) const {
    return std::atan2(z - matrix_.pose.translation.z(), distance - field_.flagRadius);
  }
  /// A flag that is seen wider and higher than it is, and at another height.
  bool locate(double distance, double bearing = 0, double wider = 1, double higher = 1,
              double lifted = 0) {
    const double half = wider * std::asin(field_.flagRadius / distance);
    const double middle = (field_.flagTop + field_.flagBottom) / 2 + lifted;
    const double halfHeight = higher * (field_.flagTop - field_.flagBottom) / 2;
    ConditionalBoundary& b = flag_.boundary;
    b.left = bearing + half;
    b.right = bearing - half;
    b.top = seen(middle + halfHeight, distance);
    b.bottom = seen(middle - halfHeight, distance);
    return locateFlag(matrix_, field_, seen(middle, distance), flag_);
  }
  void cutOff(bool left, bool right, bool top, bool bottom) {
    ConditionalBoundary& b = flag_.boundary;
    b.leftOnBorder = left;
    b.rightOnBorder = right;
    b.topOnBorder = top;
    b.bottomOnBorder = bottom;
  }
  /// Where it stands from the robot's middle.
  static Vector2d place(double distance, double bearing) {
    return Vector2d{60, 20} + distance * direction(bearing);
  }
};

TEST_F(LocateFlag, StandsWhereItsSizeSays) {
  for (const double distance : {500., 1000., 3000.})
    for (const double bearing : {-0.4, 0., 0.7}) {
      ASSERT_TRUE(locate(distance, bearing)) << distance;
      EXPECT_NEAR(flag_.distance, place(distance, bearing).norm(), 1e-6);
      EXPECT_NEAR(flag_.angle, angleOf(place(distance, bearing)), 1e-9);
    }
}

// What the image cuts off is not measured: the rest gives the same place.
TEST_F(LocateFlag, StandsWhereThePartInTheImageSays) {
  const double distance = 800, bearing = 0.3;
  for (const bool left : {false, true})
    for (const bool right : {false, true})
      for (const bool top : {false, true})
        for (const bool bottom : {false, true}) {
          cutOff(left, right, top, bottom);
          ASSERT_TRUE(locate(distance, bearing));
          ConditionalBoundary& b = flag_.boundary;
          if (left) b.left -= 0.03;
          if (right) b.right += 0.03;
          if (top) b.top -= 0.05;
          if (bottom) b.bottom += 0.05;
          ASSERT_TRUE(locateFlag(matrix_, field_, seen(310, distance), flag_));
          const bool known = !(left || right) || !(top && bottom);
          if (known) {
            EXPECT_NEAR(flag_.distance, place(distance, bearing).norm(), 1e-6)
                << left << right << top << bottom;
          } else {
            EXPECT_EQ(flag_.distance, 0);
            EXPECT_NEAR(flag_.angle, (b.left + b.right) / 2, 1e-9);
          }
          if (known && !(left && right)) {
            EXPECT_NEAR(flag_.angle, angleOf(place(distance, bearing)), 1e-9)
                << left << right << top << bottom;
          }
        }
}

// The height is twice the width and so twice as exact: its variance is a fourth.
TEST_F(LocateFlag, ItsHeightCountsFourTimesAsMuchAsItsWidth) {
  ASSERT_TRUE(locate(1000, 0, 1.25));
  const double byWidth = field_.flagRadius / std::sin(1.25 * std::asin(0.05));
  EXPECT_NEAR(flag_.distance, place(0.8 * 1000 + 0.2 * byWidth, 0).norm(), 1e-6);
}

// 200 mm high and 100 mm wide; from a camera at the height of its middle.
TEST_F(LocateFlag, IsAboutTwiceAsHighAsWide) {
  matrix_.pose.translation.z() = 310;
  for (const auto& [wider, higher, is] : {std::tuple{1., 0.65, true},
                                          {1., 0.45, false},
                                          {1., 1.45, true},
                                          {1., 1.75, false},
                                          {1.4, 1., true},
                                          {2.2, 1., false}})
    EXPECT_EQ(locate(1000, 0, wider, higher), is) << wider << " " << higher;
  cutOff(false, false, true, false);
  EXPECT_TRUE(locate(1000, 0, 1, 0.45)) << "cut off";
  EXPECT_FALSE(locate(1000, 0, 1, 1.75));
  cutOff(false, true, false, false);
  EXPECT_TRUE(locate(1000, 0, 1, 1.75)) << "cut off";
  EXPECT_FALSE(locate(1000, 0, 1, 0.45));
}

// The camera matrix errs by 70 mm and some degrees.
TEST_F(LocateFlag, StandsAtItsHeightAboveTheGround) {
  for (const double lifted : {-170., 170.}) {
    EXPECT_TRUE(locate(1000, 0, 1, 1, lifted));
    EXPECT_FALSE(locate(700, 0, 1, 1, lifted));
    EXPECT_FALSE(locate(1000, 0, 1, 1, 1.3 * lifted));
    cutOff(false, false, true, true);
    EXPECT_FALSE(locate(700, 0, 1, 1, lifted)) << "neither does its middle";
    cutOff(false, false, false, false);
  }
}

TEST_F(LocateFlag, StandsOnTheField) {
  EXPECT_TRUE(locate(5300));
  EXPECT_FALSE(locate(5700));
  EXPECT_FALSE(locate(1000, 0, -1)) << "of no width";
  EXPECT_FALSE(locate(1000, 0, 1, -1)) << "of no height";
}

}  // namespace
}  // namespace gt
