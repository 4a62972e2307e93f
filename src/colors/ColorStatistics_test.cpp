#include "colors/ColorStatistics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/Random.h"
#include "colors/TslHistogram.h"
#include "support/HalvedImage.h"

namespace gt {
namespace {

/// The first pixel of a cube of the table.
Pixel cube(int y, int cb, int cr) {
  const auto value = [](int v) { return static_cast<std::uint8_t>(4 * v); };
  return {value(y), value(cb), value(cr), 0};
}

TEST(ColorStatistics, LearnFromImagesWithKnownClasses) {
  Random random{9};
  const Pixel orange{140, 70, 190, 0}, green{90, 110, 100, 0};
  ColorStatistics statistics;
  std::vector<ColorClass> classes;
  for (int i = 0; i < 800; ++i)
    classes.push_back(i % 40 < 20 ? ColorClass::orange : ColorClass::green);
  for (int i = 0; i < 10; ++i)
    statistics.add({withNoise(halvedImage(orange, green), 3, random), classes, {}});
  // What a person states of a region, beside what the simulator states of each pixel.
  const Pixel white{230, 128, 128, 0};
  const Image wall = withNoise(halvedImage(white, orange), 3, random);
  const std::vector<LabeledRegion> regions{{"wall", ColorClass::white, {0, 0, 19, 19}}};
  statistics.add({wall, {}, regions});
  const ColorTable64 table = statistics.table(2);
  const TslColors tsl = statistics.tsl(0.99);
  const HsiColors hsi = statistics.hsi(0.99);
  const auto expectAll = [&](const auto& classifier, const char* what) {
    EXPECT_EQ(classifier[orange], ColorClass::orange) << what;
    EXPECT_EQ(classifier[green], ColorClass::green) << what;
    EXPECT_EQ(classifier[white], ColorClass::white) << what;
    EXPECT_EQ((classifier[Pixel{90, 200, 100, 0}]), ColorClass::noColor) << what;
  };
  expectAll(table, "table");
  expectAll(tsl, "TSL");
  expectAll(hsi, "HSI");
  EXPECT_GT(std::ranges::count(table.classes, ColorClass::orange),
            std::ranges::count(statistics.table(0).classes, ColorClass::orange));
}

TEST(ColorStatistics, ColorsOfSeveralClassesHaveNone) {
  ColorStatistics statistics;
  const Pixel clear = cube(20, 20, 20), mixed = cube(40, 20, 20), once = cube(60, 20, 20);
  for (int i = 0; i < 10; ++i) {
    statistics.add(clear, i < 8 ? ColorClass::yellow : ColorClass::white);
    statistics.add(mixed, i < 6 ? ColorClass::yellow : ColorClass::white);
  }
  statistics.add(once, ColorClass::yellow);
  const ColorTable64 table = statistics.table(0);
  EXPECT_EQ(table[clear], ColorClass::yellow);
  EXPECT_EQ(table[mixed], ColorClass::noColor);
  EXPECT_EQ(table[once], ColorClass::noColor) << "may be a mistake";
  EXPECT_EQ(statistics.table(0, 1)[once], ColorClass::yellow);
}

}  // namespace
}  // namespace gt
