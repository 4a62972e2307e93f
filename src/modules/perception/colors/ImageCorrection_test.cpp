#include "modules/perception/colors/ImageCorrection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

/// A table that knows the drawn field's colors in the light that it was made for.
ColorTable64 tableOfField() {
  const auto pixel = [](const Vector3d& color) {
    return Pixel{static_cast<std::uint8_t>(color[0]), static_cast<std::uint8_t>(color[1]),
                 static_cast<std::uint8_t>(color[2]), 0};
  };
  return Palette{{{ColorClass::green, pixel(fieldGreen)}, {ColorClass::white, pixel(fieldWhite)}},
                 fieldBlack}
      .table(45);
}

/// What a camera with a cast in its corners sees.
struct CastField : DrawnField {
  ImageCorrection correction;
  ColorTable64 colors = tableOfField();

  const Image& look(double light, double cast = 0) {
    Random random{1};
    draw(fieldAt, light, 1, random);
    for (int y = 0; y < image.info.height; ++y)
      for (int x = 0; x < image.info.width; ++x) {
        const double right = (2 * x + 1.0) / image.info.width - 1;
        const double down = (2 * y + 1.0) / image.info.height - 1;
        std::uint8_t& cb = image.at(x, y).cb;
        cb = static_cast<std::uint8_t>(std::lround(cb + cast * (right * right + down * down) / 2));
      }
    return correction.correct(image, horizonOf(matrix), colors);
  }
};

TEST(ImageCorrection, LeavesAnImageAloneThatTheTableWasMadeFor) {
  CastField field;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(&field.look(1), &field.image);
  EXPECT_EQ(field.correction.gain(), 1);
}

TEST(ImageCorrection, MakesAnImageAsBrightAsTheTablesImages) {
  for (const double light : {0.4, 0.5, 1.6}) {
    CastField field;
    const Image& image = field.look(light);
    EXPECT_NEAR(field.correction.gain(), 1 / light, 0.15 / light) << light;
    int right = 0, all = 0;
    for (int y = image.info.height / 2; y < image.info.height; y += 5)
      for (int x = 0; x < image.info.width; x += 5, ++all)
        right += field.colors[image.at(x, y)] != ColorClass::noColor ? 1 : 0;
    EXPECT_GT(right, 0.9 * all) << light;
    EXPECT_EQ(image.time, field.image.time);
  }
}

TEST(ImageCorrection, FollowsTheLight) {
  CastField field;
  field.look(1);
  for (int i = 0; i < 10; ++i) field.look(0.5);
  EXPECT_NEAR(field.correction.gain(), 2, 0.3);
}

TEST(ImageCorrection, OneImageInOtherLightHardlyCounts) {
  CastField field;
  for (int i = 0; i < 10; ++i) field.look(1);
  field.look(0.4);
  EXPECT_LT(field.correction.gain(), 1.5);
}

TEST(ImageCorrection, ForgetsACastThatIsGone) {
  CastField field;
  for (int i = 0; i < 20; ++i) field.look(1, 16);
  for (int i = 0; i < 30; ++i) field.look(1);
  EXPECT_NEAR(field.correction.cast().x(), 0, 2);
}

TEST(ImageCorrection, TakesTheCastOfTheCornersAway) {
  for (const double light : {1., 0.5})
    for (const double cast : {16., -10.}) {
      CastField field;
      for (int i = 0; i < 20; ++i) field.look(light, cast);
      EXPECT_NEAR(field.correction.cast().x(), cast, 2) << light;
      EXPECT_NEAR(field.correction.cast().y(), 0, 1.5) << light;
      const Image& image = field.look(light, cast);
      const Pixel corner = image.at(2, image.info.height - 3);
      EXPECT_NEAR(corner.cb, field.colors[corner] == ColorClass::green ? fieldGreen[1] : 128, 8)
          << light;
    }
}

TEST(ImageCorrection, ATableToWhichLightDoesNotMatterNeedsNoGain) {
  CastField field;
  field.colors = blackWhiteTable();
  EXPECT_EQ(&field.look(0.5), &field.image);
}

TEST(ImageCorrection, LearnsNothingWithoutCarpet) {
  CastField field;
  field.matrix = cameraAt({0, 0, 170}, 0, 0.8, 0);
  EXPECT_EQ(&field.look(0.5, 16), &field.image);
}

// Each pixel, the cast that grows with the square of the distance from the middle taken away, and
// brighter and more colorful by the gain.
TEST(ImageCorrection, CorrectsEachPixelByGainAndCast) {
  CastField field;
  for (int i = 0; i < 20; ++i) field.look(0.5, 12);
  Random random{2};
  for (int i = 0; i < 2000; ++i) {
    const int x = static_cast<int>(random.index(176)), y = static_cast<int>(random.index(10));
    field.image.at(x, y) = {static_cast<std::uint8_t>(random()),
                            static_cast<std::uint8_t>(random()),
                            static_cast<std::uint8_t>(random()), 7};
  }
  const Image& image = field.correction.correct(field.image, horizonOf(field.matrix), field.colors);
  const double gain = field.correction.gain();
  EXPECT_NEAR(gain, 2, 0.2);
  const Vector2d cast = field.correction.cast();
  EXPECT_NEAR(cast.x(), 12, 1.5);
  for (int y = 0; y < image.info.height; ++y)
    for (int x = 0; x < image.info.width; ++x) {
      const double right = (x + 0.5) / 88 - 1, down = (y + 0.5) / 72 - 1;
      const double outward = (right * right + down * down) / 2;
      const auto expected = [&](double value, double gray, double off) {
        return std::clamp((value - gray - off * outward) * gain + gray, 0., 255.);
      };
      const Pixel &from = field.image.at(x, y), &to = image.at(x, y);
      ASSERT_NEAR(to.y, expected(from.y, 0, 0), 1);
      ASSERT_NEAR(to.cb, expected(from.cb, 128, cast.x()), 1) << x << " " << y;
      ASSERT_NEAR(to.cr, expected(from.cr, 128, cast.y()), 1) << x << " " << y;
      ASSERT_EQ(to.unused, from.unused);
    }
}

TEST(ImageCorrection, TheGainHasLimits) {
  CastField dark;
  dark.look(0.2);
  EXPECT_EQ(dark.correction.gain(), 4) << "above it there is only noise";
  CastField same;
  same.look(0.9);
  EXPECT_EQ(same.correction.gain(), 1) << "so little light is not worth it";
}

TEST(ImageCorrection, ACastHasALimitAndMustBeWorthIt) {
  CastField little;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(&little.look(1, 3), &little.image);
  CastField some;
  for (int i = 0; i < 20; ++i) some.look(1, 6);
  EXPECT_NE(&some.look(1, 6), &some.image);
}

}  // namespace
}  // namespace gt
