#include "colors/TslColors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Tsl, OfKnownColors) {
  const Tsl green = tslOf(Rgb{0, 255, 0});
  EXPECT_EQ(green.saturation, 255);  // sqrt(9/5 * (1/9 + 4/9)) = 1
  EXPECT_EQ(green.luminance, 150);
  EXPECT_EQ(green.tint, 45);                         // atan(-1/2) / 2 pi + 1/4 = 0.1762
  EXPECT_EQ(tslOf(Rgb{255, 0, 0}).tint, 147);        // atan(-2) / 2 pi + 3/4 = 0.5738
  EXPECT_EQ(tslOf(Rgb{255, 255, 0}).tint, 96);       // 1/8 + 1/4
  EXPECT_EQ(tslOf(Rgb{0, 0, 255}).tint, 224);        // 1/8 + 3/4
  EXPECT_EQ(tslOf(Rgb{0, 0, 255}).saturation, 161);  // sqrt(9/5 * 2/9)
  for (const double light : {0.0, 100.0, 255.0}) {
    const Tsl gray = tslOf(Rgb{light, light, light});
    EXPECT_EQ(gray.tint, 0);
    EXPECT_EQ(gray.saturation, 0);
    EXPECT_EQ(gray.luminance, light);
  }
}

// More robust against luminance variation than YUV (report J.6.3): in a quarter of the light tint
// and saturation of a surface are the same, its chrominance is not.
TEST(Tsl, LightChangesLuminanceOnly) {
  Random random{5};
  for (int i = 0; i < 200; ++i) {
    const Rgb bright{random.uniform(1, 255), random.uniform(1, 255), random.uniform(1, 255)};
    const Rgb dark{bright.red / 4, bright.green / 4, bright.blue / 4};
    const Tsl a = tslOf(bright), b = tslOf(dark);
    EXPECT_EQ(a.tint, b.tint);
    EXPECT_EQ(a.saturation, b.saturation);
    EXPECT_NEAR(a.luminance, 4 * b.luminance, 2.5);
  }
}

TslColors someColors() {
  TslColors colors;
  colors.classes[ColorClass::orange] = {2, {110, 140}, {60, 255}, {40, 200}};
  colors.classes[ColorClass::yellow] = {1, {90, 120}, {60, 255}, {40, 255}};
  colors.classes[ColorClass::skyblue] = {3, {250, 20}, {30, 120}, {60, 220}};
  return colors;
}

TEST(TslColors, OrderDecidesWhereClassesOverlap) {
  TslColors colors = someColors();
  const Tsl both{115, 100, 100};
  EXPECT_THAT(colors.order(),
              ElementsAre(ColorClass::yellow, ColorClass::orange, ColorClass::skyblue));
  EXPECT_EQ(colors.classOf(both), ColorClass::yellow);
  colors.moveDown(ColorClass::yellow);
  EXPECT_THAT(colors.order(),
              ElementsAre(ColorClass::orange, ColorClass::yellow, ColorClass::skyblue));
  EXPECT_EQ(colors.classOf(both), ColorClass::orange);
  EXPECT_EQ(colors.classOf({100, 100, 100}), ColorClass::yellow);
  EXPECT_EQ(colors.classOf({255, 100, 100}), ColorClass::skyblue) << "across zero";
  EXPECT_EQ(colors.classOf({10, 100, 100}), ColorClass::skyblue) << "across zero";
  EXPECT_EQ(colors.classOf({60, 100, 100}), ColorClass::noColor);
  const TslColors before = colors;
  colors.moveUp(ColorClass::orange);
  colors.moveDown(ColorClass::skyblue);
  colors.moveUp(ColorClass::pink);
  EXPECT_EQ(colors, before) << "at its end, or not defined";
  colors.moveUp(ColorClass::skyblue);
  EXPECT_THAT(colors.order(),
              ElementsAre(ColorClass::orange, ColorClass::skyblue, ColorClass::yellow));
}

TEST(TslColors, ConvertToTheTable) {
  const TslColors colors = someColors();
  const ColorTable64 table = colors.table();
  Random random{2};
  int agree = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random.index(256)); };
    const Pixel pixel{byte(), byte(), byte(), 0};
    agree += table[pixel] == colors[pixel];
  }
  EXPECT_GT(agree, 0.97 * 20000);
}

TEST(TslColors, AreKeptByTheirFile) {
  const auto read = parseTslColors(tslText(someColors()), "t");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, someColors());
}

TEST(TslColors, TellWhatIsWrong) {
  const auto errorOf = [](const std::string& text) {
    const auto read = parseTslColors(text, "t.tsl");
    EXPECT_FALSE(read) << text;
    return read ? std::string{} : read.error().text();
  };
  EXPECT_THAT(errorOf("[orange]\ntint 10 256\n"), HasSubstr("t.tsl:2: orange.tint"));
  EXPECT_THAT(errorOf("[orange]\npriority 1\n"), HasSubstr("orange.saturation: this class has no"));
  EXPECT_THAT(errorOf("[orange]\nsaturation 5 10\nluminance 9 8\n"),
              HasSubstr("orange.luminance: the minimum 9 is above the maximum 8"));
  EXPECT_THAT(errorOf("[noColor]\npriority 1\n"), HasSubstr("noColor: has no ranges"));
}

}  // namespace
}  // namespace gt
