#include "colors/HsiEditor.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

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

}  // namespace
}  // namespace gt
