#include "colors/HsiColors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

using testing::HasSubstr;

void expectHsi(const Rgb& color, int hue, int saturation, int intensity) {
  const Hsi hsi = hsiOf(color);
  EXPECT_EQ(hsi.hue, hue);
  EXPECT_EQ(hsi.saturation, saturation);
  EXPECT_EQ(hsi.intensity, intensity);
}

TEST(Hsi, OfKnownColors) {
  expectHsi({255, 0, 0}, 0, 100, 33);
  expectHsi({255, 255, 0}, 60, 100, 67);
  expectHsi({0, 255, 0}, 120, 100, 33);
  expectHsi({0, 0, 255}, 240, 100, 33);
  expectHsi({255, 0, 255}, 300, 100, 67);
  expectHsi({255, 0, 64}, 346, 100, 42);  // 360 - acos(223 / sqrt(255^2 - 191 * 64))
  expectHsi({200, 100, 100}, 0, 25, 52);  // 1 - 3 * 100 / 400, 400 / 765
  expectHsi({255, 255, 255}, 0, 0, 100);
  expectHsi({0, 0, 0}, 0, 0, 0);
}

TEST(HsiRange, LeadsAcrossZero) {
  // The report's example: red from 350 to 15.
  const HsiRange red{{350, 15}, {20, 80}, {10, 90}};
  for (const int hue : {350, 355, 359, 0, 15}) EXPECT_TRUE(red.contains({hue, 20, 90})) << hue;
  for (const int hue : {16, 180, 349}) EXPECT_FALSE(red.contains({hue, 50, 50})) << hue;
  EXPECT_FALSE(red.contains({0, 19, 50}));
  EXPECT_FALSE(red.contains({0, 81, 50}));
  EXPECT_FALSE(red.contains({0, 50, 9}));
  EXPECT_FALSE(red.contains({0, 50, 91}));
  EXPECT_TRUE((HsiRange{{300, 360}, {0, 100}, {0, 100}}.contains({0, 50, 50}))) << "360 is 0";
  EXPECT_FALSE(HsiRange{}.contains({0, 50, 50}));
}

TEST(HsiRange, GrowsAndShrinksByClicks) {
  Random random{4};
  HsiRange range;
  std::vector<Hsi> inside;
  const auto some = [&] {
    return Hsi{static_cast<int>(random.index(360)), static_cast<int>(random.index(101)),
               static_cast<int>(random.index(101))};
  };
  for (int i = 0; i < 500; ++i) {
    const Hsi color = some();
    const HsiRange before = range;
    const bool was = range.contains(color);
    if (random.chance(0.5)) {
      range.include(color);
      EXPECT_TRUE(range.contains(color)) << i;
      if (was) {
        EXPECT_EQ(range, before) << i << ": what lies inside changes nothing";
      }
      for (int k = 0; k < 20; ++k) {
        const Hsi other = some();
        EXPECT_TRUE(range.contains(other) || !before.contains(other)) << i;
      }
    } else {
      range.exclude(color);
      EXPECT_FALSE(range.contains(color)) << i;
      if (!was) {
        EXPECT_EQ(range, before) << i << ": what lies outside changes nothing";
      }
    }
  }
}

TEST(HsiRange, ChangesNoMoreThanItMust) {
  HsiRange range;
  range.include({350, 40, 50});
  EXPECT_EQ(range, (HsiRange{{350, 350}, {40, 40}, {50, 50}}));
  range.include({10, 60, 30});
  EXPECT_EQ(range, (HsiRange{{350, 10}, {40, 60}, {30, 50}})) << "20 degrees, not 340";
  range.exclude({9, 50, 40});
  EXPECT_EQ(range, (HsiRange{{350, 8}, {40, 60}, {30, 50}})) << "hue loses least";
  range.exclude({359, 59, 40});
  EXPECT_EQ(range, (HsiRange{{350, 8}, {40, 58}, {30, 50}})) << "saturation loses least";
  HsiRange white{{0, 360}, {0, 10}, {70, 100}};
  white.exclude({77, 8, 90});
  EXPECT_EQ(white, (HsiRange{{0, 360}, {0, 7}, {70, 100}})) << "a circle has no end to cut";
}

TEST(HsiColors, ConvertToTheTable) {
  HsiColors colors;
  colors.ranges[ColorClass::orange] = {{10, 45}, {40, 100}, {20, 90}};
  colors.ranges[ColorClass::yellow] = {{40, 70}, {40, 100}, {20, 90}};
  const ColorTable64 table = colors.table();
  Random random{2};
  int agree = 0, all = 20000;
  for (int i = 0; i < all; ++i) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random.index(256)); };
    const Pixel pixel{byte(), byte(), byte(), 0};
    agree += table[pixel] == colors[pixel];
    const auto middle = [](std::uint8_t v) { return (v & ~3) + 1.5; };
    EXPECT_EQ(table[pixel],
              colors.classOf(hsiOf(rgbOf(middle(pixel.y), middle(pixel.cb), middle(pixel.cr)))));
  }
  EXPECT_GT(agree, 0.97 * all);
  EXPECT_EQ(colors.classOf({42, 80, 50}), ColorClass::orange) << "the first in the list of classes";
}

TEST(HsiColors, AreKeptByTheirFile) {
  HsiColors colors;
  colors.ranges[ColorClass::red] = {{350, 15}, {30, 100}, {5, 70}};
  colors.ranges[ColorClass::white] = {{0, 360}, {0, 12}, {60, 100}};
  const auto read = parseHsiColors(hsiText(colors), "t");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, colors);
  EXPECT_EQ(*parseHsiColors("", "t"), HsiColors{});
}

TEST(HsiColors, TellWhatIsWrong) {
  const auto errorOf = [](const std::string& text) {
    const auto read = parseHsiColors(text, "t.hsi");
    EXPECT_FALSE(read) << text;
    return read ? std::string{} : read.error().text();
  };
  EXPECT_THAT(errorOf("[orange]\nhue 10 361\n"), HasSubstr("t.hsi:2: orange.hue"));
  EXPECT_THAT(errorOf("[orange]\nhue 10\n"), HasSubstr("t.hsi:2: orange.hue"));
  EXPECT_THAT(errorOf("[purple]\n"), HasSubstr("t.hsi:1: purple"));
  EXPECT_THAT(errorOf("[orange]\nhue 10 20\n"), HasSubstr("orange.saturation: this class has no"));
  EXPECT_THAT(errorOf("[orange]\nsaturation 50 40\nintensity 1 2\n"),
              HasSubstr("orange.saturation: the minimum 50 is above the maximum 40"));
  EXPECT_THAT(errorOf("[noColor]\nhue 1 2\n"), HasSubstr("noColor: has no ranges"));
  EXPECT_THAT(readHsiColors("no/such.hsi").error().text(), HasSubstr("no/such.hsi"));
}

}  // namespace
}  // namespace gt
