#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/Random.h"
#include "colors/ColorConfusion.h"
#include "colors/ColorStatistics.h"
#include "colors/ColorTableEditor.h"
#include "colors/HsiEditor.h"
#include "colors/TslHistogram.h"

namespace gt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The first pixel of a cube of the table.
Pixel cube(int y, int cb, int cr) {
  const auto value = [](int v) { return static_cast<std::uint8_t>(4 * v); };
  return {value(y), value(cb), value(cr), 0};
}

TEST(ColorTableEditor, AssignsCubesOfColors) {
  ColorTableEditor editor;
  editor.set({101, 50, 203, 0}, ColorClass::orange);
  for (const int y : {100, 103})
    for (const int cb : {48, 51})
      for (const int cr : {200, 203})
        EXPECT_EQ((editor.table()[Pixel{static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(cb),
                                        static_cast<std::uint8_t>(cr), 0}]),
                  ColorClass::orange);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::orange), 1);
  editor.remove({100, 51, 202, 0});
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::noColor), 64 * 64 * 64);
}

TEST(ColorTableEditor, TakesEachStepBack) {
  ColorTableEditor editor;
  std::vector<ColorTable64> states;
  const auto step = [&](auto&& change) {
    states.push_back(editor.table());
    change();
    EXPECT_NE(states.back().classes, editor.table().classes) << states.size();
  };
  step([&] { editor.set(cube(20, 20, 20), ColorClass::green); });
  step([&] { editor.set(cube(20, 20, 22), ColorClass::green); });
  step([&] { editor.set(cube(20, 20, 21), ColorClass::white); });
  step([&] { editor.median({2, 1, true}, ColorClass::green); });
  step([&] { editor.set(cube(50, 20, 21), ColorClass::pink); });
  step([&] { editor.removeIsolated(); });
  step([&] { editor.clear(ColorClass::green); });
  step([&] { editor.set(cube(9, 9, 9), ColorClass::red); });
  step([&] { editor.reset(); });
  editor.reset();  // changes nothing, so that it is no step
  for (; !states.empty(); states.pop_back()) {
    EXPECT_TRUE(editor.undo());
    EXPECT_EQ(editor.table().classes, states.back().classes) << states.size();
  }
  EXPECT_FALSE(editor.undo());
}

TEST(ColorTableEditor, RemovesWhatHasNoNeighbor) {
  ColorTableEditor editor;
  editor.set(cube(10, 10, 10), ColorClass::green);
  editor.set(cube(11, 11, 11), ColorClass::green);   // touches by a corner
  editor.set(cube(30, 10, 10), ColorClass::green);   // alone
  editor.set(cube(30, 10, 11), ColorClass::orange);  // alone: its neighbour is of another class
  editor.set(cube(0, 0, 63), ColorClass::orange);    // no neighbour round the corner
  editor.set(cube(0, 1, 0), ColorClass::orange);
  editor.removeIsolated(ColorClass::green);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 2);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::orange), 3);
  editor.removeIsolated();
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::orange), 0);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 2);
}

TEST(ColorTableEditor, MedianAddsWhatHasEnoughNear) {
  ColorTableEditor editor;
  editor.set(cube(10, 10, 10), ColorClass::green);
  editor.set(cube(10, 10, 12), ColorClass::green);
  editor.set(cube(10, 12, 11), ColorClass::white);
  const auto at = [&](int y, int cb, int cr) { return editor.table()[cube(y, cb, cr)]; };
  editor.median({3, 1, false}, ColorClass::green);
  EXPECT_EQ(at(10, 10, 11), ColorClass::noColor) << "two are not three";
  editor.median({2, 1, false}, ColorClass::green);
  EXPECT_EQ(at(10, 10, 11), ColorClass::green);
  EXPECT_EQ(at(10, 11, 11), ColorClass::noColor) << "1.4 away";
  editor.median({3, 2, false}, ColorClass::green);
  EXPECT_EQ(at(10, 11, 11), ColorClass::green);
  EXPECT_EQ(at(10, 12, 11), ColorClass::white) << "has a class already";
  editor.median({2, 2, true}, ColorClass::green);
  EXPECT_EQ(at(10, 12, 11), ColorClass::green);
}

TEST(ColorTableEditor, MedianOfAllColorsTakesThatOfWhichThereAreMost) {
  ColorTableEditor editor;
  for (const int cr : {9, 11}) editor.set(cube(10, 10, cr), ColorClass::green);
  for (const int cb : {9, 11}) editor.set(cube(10, cb, 10), ColorClass::orange);
  editor.set(cube(9, 10, 10), ColorClass::orange);
  editor.median({2, 1, false});
  EXPECT_EQ(editor.table()[cube(10, 10, 10)], ColorClass::orange);
}

TEST(ColorTableEditor, FilteringPicturesBelongsToTheStepBefore) {
  ColorTableEditor editor;
  editor.set(cube(10, 10, 10), ColorClass::green);
  editor.set(cube(10, 10, 12), ColorClass::green);
  const ColorTable64 before = editor.table();
  editor.set(cube(40, 10, 12), ColorClass::green);
  AutomaticFilters filters;
  filters.median = filters.remove = true;
  filters.rule = {2, 1, false};
  for (int picture = 0; picture < 3; ++picture) editor.onPicture(filters);
  EXPECT_EQ(editor.table()[cube(10, 10, 11)], ColorClass::noColor) << "they were alone";
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 0);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.table().classes, before.classes);
}

TEST(HsiEditor, TakesSixChangesBack) {
  HsiEditor editor;
  std::vector<HsiColors> states;
  Random random{3};
  for (int i = 0; i < 6; ++i) {
    states.push_back(editor.colors());
    const auto byte = [&] { return static_cast<std::uint8_t>(random.index(256)); };
    const Pixel pixel{byte(), byte(), byte(), 0};
    editor.include(ColorClass::yellow, pixel);
    if (editor.colors() == states.back())
      states.pop_back();
    else
      EXPECT_EQ(editor.colors()[pixel], ColorClass::yellow);
  }
  states.push_back(editor.colors());
  editor.setRange(ColorClass::red, {{-5, 400}, {10, 200}, {0, 50}});
  EXPECT_EQ(editor.colors().ranges[ColorClass::red], (HsiRange{{0, 360}, {10, 100}, {0, 50}}));
  const Pixel inside{60, 128, 170, 0};
  ASSERT_EQ(editor.colors()[inside], ColorClass::red);
  states.push_back(editor.colors());
  editor.exclude(ColorClass::red, inside);
  EXPECT_NE(editor.colors()[inside], ColorClass::red);
  for (; !states.empty(); states.pop_back()) {
    EXPECT_TRUE(editor.undo());
    EXPECT_EQ(editor.colors(), states.back());
  }
  EXPECT_FALSE(editor.undo());
}

TEST(ChannelHistogram, TakesTheNarrowestRange) {
  ChannelHistogram line{10};
  for (const int value : {0, 4, 4, 4, 5, 6, 6, 9}) line.add(value);
  EXPECT_EQ(line.narrowest(1), (ColorRange{0, 9}));
  EXPECT_EQ(line.narrowest(0.75), (ColorRange{4, 6}));
  EXPECT_EQ(line.narrowest(0.3), (ColorRange{4, 4}));
  ChannelHistogram circle{10, true};
  for (const int value : {8, 9, 0, 0, 1, 5}) circle.add(value);
  EXPECT_EQ(circle.narrowest(0.8), (ColorRange{8, 1})) << "across zero";
  EXPECT_EQ(circle.narrowest(1), (ColorRange{5, 1}));
  EXPECT_FALSE(inRange(ChannelHistogram{10}.narrowest(1), 0)) << "nothing was seen";
}

/// A picture whose left half has one colour and whose right half another one.
Image halves(const Pixel& left, const Pixel& right) {
  Image image;
  image.info.width = 40;
  image.info.height = 20;
  image.allocate();
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) image.at(x, y) = x < 20 ? left : right;
  return image;
}

TEST(TslHistogram, SetsThresholdsFromARegion) {
  Random random{8};
  const Pixel orange{140, 70, 190, 0}, green{90, 110, 100, 0};
  const Image image = withNoise(halves(orange, green), 3, random);
  TslHistogram histogram;
  histogram.add(image, {-5, 2, 19, 300});  // what lies outside of the picture does not count
  EXPECT_EQ(histogram.tint().total(), 20u * 18u);
  TslColors colors;
  colors.classes[ColorClass::orange] = histogram.thresholds(0.99);
  ColorConfusion confusion;
  const auto classify = [&](const Image& picture) {
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x)
        confusion.add(x < 20 ? ColorClass::orange : ColorClass::noColor, colors[picture.at(x, y)]);
  };
  classify(image);
  EXPECT_GT(confusion.recall(ColorClass::orange), 0.97);
  EXPECT_EQ(confusion.precision(ColorClass::orange), 1);
  // The thresholds are as narrow as they can be: with twice the noise much is lost.
  confusion = {};
  classify(withNoise(image, 6, random));
  EXPECT_LT(confusion.recall(ColorClass::orange), 0.9);
  EXPECT_EQ(TslHistogram{}.thresholds(), TslThresholds{});
}

TEST(ColorStatistics, LearnFromPicturesWithKnownClasses) {
  Random random{9};
  const Pixel orange{140, 70, 190, 0}, green{90, 110, 100, 0};
  ColorStatistics statistics;
  std::vector<ColorClass> classes;
  for (int i = 0; i < 800; ++i)
    classes.push_back(i % 40 < 20 ? ColorClass::orange : ColorClass::green);
  for (int i = 0; i < 10; ++i)
    statistics.add({withNoise(halves(orange, green), 3, random), classes, {}});
  // What a person says of a region, beside what the simulator says of each pixel.
  const Pixel white{230, 128, 128, 0};
  const Image wall = withNoise(halves(white, orange), 3, random);
  const std::vector<LabelledRegion> regions{{"wall", ColorClass::white, {0, 0, 19, 19}}};
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

TEST(ColorConfusion, TellsPrecisionAndRecall) {
  ColorConfusion confusion;
  confusion.add(ColorClass::orange, ColorClass::orange, 6);
  confusion.add(ColorClass::orange, ColorClass::yellow, 2);
  confusion.add(ColorClass::yellow, ColorClass::orange, 4);
  confusion.add(ColorClass::noColor, ColorClass::noColor, 8);
  EXPECT_DOUBLE_EQ(confusion.precision(ColorClass::orange), 0.6);
  EXPECT_DOUBLE_EQ(confusion.recall(ColorClass::orange), 0.75);
  EXPECT_DOUBLE_EQ(confusion.recall(ColorClass::yellow), 0);
  EXPECT_DOUBLE_EQ(confusion.agreement(), 0.7);
  EXPECT_THAT(confusion.text("truth", "table"), HasSubstr("60.0%     75.0%"));
  EXPECT_THAT(confusion.text("truth", "table"), testing::Not(HasSubstr("pink")));
  ColorTableEditor editor;
  editor.set(cube(1, 2, 3), ColorClass::pink);
  const ColorConfusion tables = compareTables(editor.table(), ColorTable64{});
  EXPECT_EQ(tables.count(ColorClass::pink, ColorClass::noColor), 1u);
  EXPECT_EQ(tables.total(), 64u * 64u * 64u);
}

TEST(PictureRegions, AreReadFromATable) {
  const std::string heading = "picture,class,left,top,right,bottom\n";
  const auto regions = parseRegions(heading + "12,orange,3,4,5,6\r\n\na.jpg,white,0,0,0,0", "t");
  ASSERT_TRUE(regions) << regions.error().text();
  ASSERT_EQ(regions->size(), 2u);
  EXPECT_EQ((*regions)[0].picture, "12");
  EXPECT_EQ((*regions)[0].region.bottom, 6);
  EXPECT_EQ((*regions)[1].colorClass, ColorClass::white);
  const auto errorOf = [&](const std::string& row) {
    const auto read = parseRegions(heading + row, "t.csv");
    EXPECT_FALSE(read) << row;
    return read ? std::string{} : read.error().text();
  };
  EXPECT_THAT(errorOf("1,orange,3,4,5"), HasSubstr("t.csv:2: expected picture,class"));
  EXPECT_THAT(errorOf("1,purple,3,4,5,6"), HasSubstr("t.csv:2: class"));
  EXPECT_THAT(errorOf("1,pink,3,4,2,6"), HasSubstr("t.csv:2: right"));
  EXPECT_THAT(errorOf("1,pink,3,-4,5,6"), HasSubstr("t.csv:2: top"));
  EXPECT_THAT(errorOf("1,pink,3,4,5,99999999999"), HasSubstr("t.csv:2: bottom"));
  EXPECT_THAT(errorOf(",pink,3,4,5,6"), HasSubstr("t.csv:2: picture"));
  EXPECT_THAT(errorOf(""), HasSubstr("t.csv:1: expected a table"));
}

}  // namespace
}  // namespace gt
