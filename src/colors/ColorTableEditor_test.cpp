#include "colors/ColorTableEditor.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

/// The first pixel of a cube of the table.
Pixel cubeAt(int y, int cb, int cr) {
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
  step([&] { editor.set(cubeAt(20, 20, 20), ColorClass::green); });
  step([&] { editor.set(cubeAt(20, 20, 22), ColorClass::green); });
  step([&] { editor.set(cubeAt(20, 20, 21), ColorClass::white); });
  step([&] { editor.median({2, 1, true}, ColorClass::green); });
  step([&] { editor.set(cubeAt(50, 20, 21), ColorClass::pink); });
  step([&] { editor.removeIsolated(); });
  step([&] { editor.clear(ColorClass::green); });
  step([&] { editor.set(cubeAt(9, 9, 9), ColorClass::red); });
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
  editor.set(cubeAt(10, 10, 10), ColorClass::green);
  editor.set(cubeAt(11, 11, 11), ColorClass::green);   // touches by a corner
  editor.set(cubeAt(30, 10, 10), ColorClass::green);   // alone
  editor.set(cubeAt(30, 10, 11), ColorClass::orange);  // alone: its neighbor is of another class
  editor.set(cubeAt(0, 0, 63), ColorClass::orange);    // no neighbor round the corner
  editor.set(cubeAt(0, 1, 0), ColorClass::orange);
  editor.removeIsolated(ColorClass::green);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 2);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::orange), 3);
  editor.removeIsolated();
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::orange), 0);
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 2);
}

TEST(ColorTableEditor, MedianAddsWhatHasEnoughNear) {
  ColorTableEditor editor;
  editor.set(cubeAt(10, 10, 10), ColorClass::green);
  editor.set(cubeAt(10, 10, 12), ColorClass::green);
  editor.set(cubeAt(10, 12, 11), ColorClass::white);
  const auto at = [&](int y, int cb, int cr) { return editor.table()[cubeAt(y, cb, cr)]; };
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
  for (const int cr : {9, 11}) editor.set(cubeAt(10, 10, cr), ColorClass::green);
  for (const int cb : {9, 11}) editor.set(cubeAt(10, cb, 10), ColorClass::orange);
  editor.set(cubeAt(9, 10, 10), ColorClass::orange);
  editor.median({2, 1, false});
  EXPECT_EQ(editor.table()[cubeAt(10, 10, 10)], ColorClass::orange);
}

TEST(ColorTableEditor, FilteringImagesBelongsToTheStepBefore) {
  ColorTableEditor editor;
  editor.set(cubeAt(10, 10, 10), ColorClass::green);
  editor.set(cubeAt(10, 10, 12), ColorClass::green);
  const ColorTable64 before = editor.table();
  editor.set(cubeAt(40, 10, 12), ColorClass::green);
  AutomaticFilters filters;
  filters.median = filters.remove = true;
  filters.rule = {2, 1, false};
  for (int picture = 0; picture < 3; ++picture) editor.onPicture(filters);
  EXPECT_EQ(editor.table()[cubeAt(10, 10, 11)], ColorClass::noColor) << "they were alone";
  EXPECT_EQ(std::ranges::count(editor.table().classes, ColorClass::green), 0);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.table().classes, before.classes);
}

}  // namespace
}  // namespace gt
