#include "modules/perception/colors/ColorAdaptation.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gt
