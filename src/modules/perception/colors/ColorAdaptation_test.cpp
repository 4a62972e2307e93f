#include "modules/perception/colors/ColorAdaptation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

class ColorAdaptationTest : public testing::Test {
 protected:
  const Vector3d orange{129, 59, 214}, yellow{195, 26, 158}, skyblue{132, 186, 63},
      pink{139, 139, 203}, red{65, 106, 212}, blue{36, 177, 115}, gray{120, 130, 128};
  ColorAdaptation colors_;
  Random random_{1};
  DrawnField scene_;

  void watch(double light, int pictures) {
    const Horizon horizon = horizonOf(scene_.matrix);
    for (int i = 0; i < pictures; ++i) {
      if (i % 10 == 0) scene_.draw(fieldAt, light, 3, random_);
      colors_.observe(scene_.image, horizon);
      colors_.refresh();
    }
  }
  double rightShare(const Vector3d& color, double light, ColorClass expected) {
    int right = 0;
    for (int i = 0; i < 500; ++i)
      right +=
          colors_.table()[pixelOf(DrawnField::lit(color, light), 2, random_)] == expected ? 1 : 0;
    return right / 500.0;
  }
};

TEST_F(ColorAdaptationTest, KnowsNothingUntilItHasSeenTheField) {
  EXPECT_EQ(rightShare(fieldGreen, 1, ColorClass::noColor), 1);
  DrawnField sky{0.6};
  sky.draw([this](const Vector3d&) { return skyblue; }, 1, 3, random_);
  for (int i = 0; i < 100; ++i) {
    colors_.observe(sky.image, horizonOf(sky.matrix));
    colors_.refresh();
  }
  EXPECT_FALSE(colors_.isGreenKnown());
  EXPECT_EQ(rightShare(fieldGreen, 1, ColorClass::noColor), 1);
}

TEST_F(ColorAdaptationTest, TellsAllColorsInAnyLightFromTheGreenOfTheGround) {
  for (const double light : {1.0, 0.5, 1.25, 0.7}) {
    watch(light, 60);
    ASSERT_TRUE(colors_.isGreenKnown());
    EXPECT_NEAR(colors_.greenY(), fieldGreen[0] * light, 4);
    for (const auto& [color, expected] : {std::pair{fieldGreen, ColorClass::green},
                                          {orange, ColorClass::orange},
                                          {yellow, ColorClass::yellow},
                                          {skyblue, ColorClass::skyblue},
                                          {pink, ColorClass::pink},
                                          {red, ColorClass::red},
                                          {blue, ColorClass::blue},
                                          {fieldWhite, ColorClass::white},
                                          {fieldBlack, ColorClass::black},
                                          {gray, ColorClass::gray}})
      EXPECT_GT(rightShare(color, light, expected), 0.9)
          << enumName(expected) << " in light " << light;
  }
}

TEST_F(ColorAdaptationTest, MovesAColorToWhereRecognizedObjectsHaveIt) {
  watch(1, 40);
  const Vector3d other{135, 66, 224};  // Redder.
  const double hue = std::atan2(224 - 128, 66 - 128);
  const double before = std::abs(normalize(colors_.tone(ColorClass::orange).hue - hue));
  for (int i = 0; i < 400; ++i) colors_.learn(ColorClass::orange, pixelOf(other, 2, random_));
  EXPECT_LT(std::abs(normalize(colors_.tone(ColorClass::orange).hue - hue)), before / 2);
  const Tone orangeTone = colors_.tone(ColorClass::orange);
  for (int i = 0; i < 400; ++i) colors_.learn(ColorClass::orange, pixelOf(skyblue, 2, random_));
  EXPECT_EQ(colors_.tone(ColorClass::orange).hue, orangeTone.hue) << "sky-blue is no orange";
}

TEST_F(ColorAdaptationTest, ForgetsTheGreenOfACarpetThatItDoesNotSeeAnyMore) {
  const Horizon horizon = horizonOf(scene_.matrix);
  const Vector3d turquoise{110, 150, 80};
  const auto watchGround = [&](const Vector3d& ground, int pictures) {
    scene_.draw([&](const Vector3d& ray) { return ray.z() < 0 ? ground : fieldWhite; }, 1, 3,
                random_);
    for (int i = 0; i < pictures; ++i) {
      colors_.observe(scene_.image, horizon);
      colors_.refresh();
    }
  };
  watchGround(turquoise, 60);
  EXPECT_GT(rightShare(turquoise, 1, ColorClass::green), 0.9);
  watchGround(fieldGreen, 70);
  EXPECT_GT(rightShare(turquoise, 1, ColorClass::green), 0.9) << "for three seconds it may lie";
  watchGround(fieldGreen, 60);
  EXPECT_GT(rightShare(fieldGreen, 1, ColorClass::green), 0.9);
  EXPECT_LT(rightShare(turquoise, 1, ColorClass::green), 0.1);
}

/// Ground of one color up to the horizon and white above it, watched until all is settled.
class OneGround : public testing::Test {
 protected:
  ColorAdaptation colors_;
  Image image_;
  Horizon horizon_{{88, 30}};

  OneGround() { image_.allocate(); }
  /// In degrees around gray; the distance from gray over the brightness.
  static Pixel paint(double y, double hue, double strength) {
    const Vector2d chroma = strength * y * direction(fromDegrees(hue));
    return {static_cast<std::uint8_t>(std::lround(y)),
            static_cast<std::uint8_t>(std::lround(128 + chroma.x())),
            static_cast<std::uint8_t>(std::lround(128 + chroma.y())), 0};
  }
  /// Columns that are so many percent of the ground may have another color.
  void watch(const Pixel& ground, int images, const Pixel& above = {230, 128, 128, 0},
             const Pixel* columns = nullptr, int share = 0) {
    for (int y = 0; y < image_.info.height; ++y)
      for (int x = 0; x < image_.info.width; ++x)
        image_.at(x, y) = y < 30 ? above : columns && x * 100 / 176 < share ? *columns : ground;
    for (int i = 0; i < images; ++i) {
      colors_.observe(image_, horizon_);
      colors_.refresh();
    }
  }
  ColorClass classOf(double y, double hue, double strength) const {
    return colors_.table()[paint(y, hue, strength)];
  }
  static constexpr double hue = -108, strength = 0.6;  ///< Of a usual carpet.
};

// 2000 pixels of ground are needed; an image has some 500 that are looked at.
TEST_F(OneGround, GreenIsKnownAfterSomeImages) {
  watch(paint(80, hue, strength), 3);
  EXPECT_FALSE(colors_.isGreenKnown());
  watch(paint(80, hue, strength), 3);
  EXPECT_TRUE(colors_.isGreenKnown());
}

TEST_F(OneGround, GreenHasTheToneOfTheGround) {
  for (const double at : {-85., -100., -113., -150.}) {
    colors_ = {};
    watch(paint(80, at, strength), 150);
    ASSERT_TRUE(colors_.isGreenKnown()) << at;
    EXPECT_NEAR(toDegrees(colors_.tone(ColorClass::green).hue), at, 1);
    EXPECT_NEAR(colors_.tone(ColorClass::green).strength, std::log(strength), 0.02);
    EXPECT_NEAR(colors_.greenY(), 80, 0.5);
  }
  for (const double at : {-55., 175., 60.}) {
    colors_ = {};
    watch(paint(80, at, strength), 150);
    EXPECT_FALSE(colors_.isGreenKnown()) << "no carpet has the hue " << at;
  }
}

TEST_F(OneGround, GreenIsWhatALargePartOfTheGroundHas) {
  const Pixel orange = paint(110, 139, 0.75);
  for (const int share : {60, 80}) {
    colors_ = {};
    watch(paint(80, hue, strength), 100, {230, 128, 128, 0}, &orange, share);
    EXPECT_EQ(colors_.isGreenKnown(), share == 60) << share;
  }
}

TEST_F(OneGround, LightIsFeltWithinAFewImages) {
  watch(paint(80, hue, strength), 50);
  watch(paint(60, hue, strength), 1);
  EXPECT_NEAR(colors_.greenY(), 75, 1.5) << "but not at once";
  watch(paint(60, hue, strength), 12);
  EXPECT_NEAR(colors_.greenY(), 60, 1);
}

TEST_F(OneGround, TheToneOfTheCarpetChangesSlowly) {
  watch(paint(80, hue, strength), 150);
  watch(paint(80, hue + 20, 1.2 * strength), 10);
  const Tone& green = colors_.tone(ColorClass::green);
  EXPECT_NEAR(toDegrees(green.hue), hue + 8, 2) << "1 - 0.95^10 of the way";
  EXPECT_NEAR(green.strength, std::log(strength) + 0.4 * std::log(1.2), 0.03);
  watch(paint(80, hue + 20, 1.2 * strength), 150);
  EXPECT_NEAR(toDegrees(green.hue), hue + 20, 1);
  EXPECT_NEAR(green.strength, std::log(1.2 * strength), 0.02);
}

TEST_F(OneGround, WhiteIsAsBrightAsTheWalls) {
  for (const int y : {150, 190, 230}) {
    colors_ = {};
    watch(paint(80, hue, strength), 50, {static_cast<std::uint8_t>(y), 128, 128, 0});
    EXPECT_NEAR(colors_.whiteY(), y, 80 * 8. / 64) << "one of 64 steps up to eight times as bright";
  }
}

TEST_F(OneGround, WhatHasNoColorIsWhiteGrayOrBlackByItsBrightness) {
  watch(paint(80, hue, strength), 50);
  for (const auto& [y, expected] : {std::pair{140, ColorClass::white},
                                    {118, ColorClass::gray},
                                    {54, ColorClass::gray},
                                    {38, ColorClass::black}})
    for (const double strength : {0., 0.1})
      EXPECT_EQ(classOf(y, 0, strength), expected) << y << " of 230";
}

// What is bright and hardly colored is white and shows gray. The same tone in the shade is gray
// then.
TEST_F(OneGround, GrayFollowsTheLight) {
  for (const auto& [cb, cr] : {std::pair{140, 128}, {116, 128}, {128, 140}, {128, 116}}) {
    const Pixel white{220, static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr), 0};
    const Pixel half{60, static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr), 0};
    colors_ = {};
    watch(paint(80, hue, strength), 10);
    EXPECT_NE(colors_.table()[half], ColorClass::gray) << cb << " " << cr;
    watch(paint(80, hue, strength), 150, white);
    EXPECT_EQ(colors_.table()[half], ColorClass::gray) << cb << " " << cr;
  }
}

// By hue in degrees and by strength; a tone between two colors belongs to the nearer one.
TEST_F(OneGround, AColorReachesSoFarAroundItsTone) {
  watch(paint(80, hue, strength), 50);
  using enum ColorClass;
  for (const double off : {-20., 0., 15.}) EXPECT_EQ(classOf(100, -57 + off, 0.85), skyblue) << off;
  for (const double more : {0.5, 0.7, 1.25}) EXPECT_EQ(classOf(90, -57, 0.85 * more), skyblue);
  EXPECT_EQ(classOf(90, -57, 0.85 * 0.28), noColor);
  for (const double off : {-30., 20.}) EXPECT_EQ(classOf(100, 80 + off, 0.45), pink) << off;
  EXPECT_EQ(classOf(100, 35, 0.45), noColor) << "between pink and blue";
  EXPECT_EQ(classOf(100, 100, 0.45), pink);
  EXPECT_EQ(classOf(80, 105, 1.0), red);
  EXPECT_EQ(classOf(100, 135, 0.7), orange);
  EXPECT_EQ(classOf(100, 170, 0.6), yellow);
  EXPECT_EQ(classOf(100, 192, 0.6), yellow);
  EXPECT_EQ(classOf(100, 151, 0.7), orange);
  EXPECT_EQ(classOf(100, 163, 0.57), yellow);
}

TEST_F(OneGround, RefreshesTheTableWithinEightCalls) {
  watch(paint(80, hue, strength), 3);
  for (int i = 0; i < 20; ++i) colors_.observe(image_, horizon_);
  const auto planes = [&] {
    int known = 0;
    for (int cb = 2; cb < 256; cb += 4)
      known += colors_.table()[{100, static_cast<std::uint8_t>(cb), 130, 0}] != ColorClass::noColor;
    return known;
  };
  std::array<int, 10> known{};
  for (int& now : known) {
    colors_.refresh();
    now = planes();
  }
  EXPECT_GT(known[7], known[6]);
  EXPECT_EQ(known[8], known[7]);
  EXPECT_EQ(known[9], known[7]);
}

class LearnedColors : public OneGround {
 protected:
  static constexpr double known = -57, strong = 0.85;  ///< The tone of sky-blue.
  double learnedHue() const { return toDegrees(colors_.tone(ColorClass::skyblue).hue); }
  void learn(const Pixel& pixel, int times) {
    for (int i = 0; i < times; ++i) colors_.learn(ColorClass::skyblue, pixel);
  }
};

TEST_F(LearnedColors, MoveSlowlyToWhereObjectsHaveThem) {
  learn(paint(100, known + 12, strong), 100);
  EXPECT_NEAR(learnedHue(), known + 12 * 0.63, 1) << "1 - 0.99^100 of the way";
  learn(paint(100, known + 12, strong), 1000);
  EXPECT_NEAR(learnedHue(), known + 12, 0.7);
  const double before = colors_.tone(ColorClass::skyblue).strength;
  learn(paint(100, known + 12, 1.2 * strong), 100);
  EXPECT_NEAR(colors_.tone(ColorClass::skyblue).strength, before + 0.63 * std::log(1.2), 0.02);
}

TEST_F(LearnedColors, StayNearWhatIsKnown) {
  for (const double sign : {-1., 1.}) {
    colors_ = {};
    for (int i = 0; i < 1000; ++i) learn(paint(100, learnedHue() + sign * 10, strong), 1);
    EXPECT_NEAR(learnedHue(), known + sign * 30, 0.5);
    colors_ = {};
    for (int i = 0; i < 3000; ++i)
      learn(
          paint(60, known, (1 + sign * 0.3) * std::exp(colors_.tone(ColorClass::skyblue).strength)),
          1);
    EXPECT_NEAR(colors_.tone(ColorClass::skyblue).strength, std::log(strong) + sign * 0.7, 0.02);
  }
}

TEST_F(LearnedColors, AreNotLearnedFromWhatHardlyHasThem) {
  learn(paint(254, known + 12, 0.4), 100);
  learn(paint(100, known + 35, strong), 100);
  learn(paint(7, known + 12, 0.8), 100);
  EXPECT_NEAR(learnedHue(), known, 1e-9);
}

}  // namespace
}  // namespace gt
