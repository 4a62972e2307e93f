#include "base/CrashNotes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace gt {
namespace {

using ::testing::IsEmpty;

std::string context() {
  std::string text;
  CrashContext::forEachPart([&](std::string_view part) { text += part; });
  return text;
}

std::vector<std::string> textsOf(const CrashNotes& notes) {
  std::vector<std::string> texts;
  for (auto note = notes.begin(); note < notes.end(); ++note) {
    std::string& text = texts.emplace_back();
    notes.forEachLetter(note, [&](char letter) { text += letter; });
  }
  return texts;
}

TEST(CrashContext, IsOfItsThreadAndNested) {
  EXPECT_EQ(context(), "");
  const CrashContext robot{"red1"};
  {
    const CrashContext process{"Cognition", Time{4800}}, module{"BallLocator"};
    EXPECT_EQ(context(), "red1, Cognition at 4800 ms, BallLocator");
    std::thread{[] { EXPECT_EQ(context(), ""); }}.join();
  }
  EXPECT_EQ(context(), "red1");
}

TEST(CrashContext, OfManyTheInnermostOnesAreNamed) {
  std::vector<std::unique_ptr<CrashContext>> open;
  for (int i = 0; i < 20; ++i)
    open.push_back(std::make_unique<CrashContext>(i < 4 ? "outer" : "inner"));
  EXPECT_EQ(context().find("outer"), std::string::npos);
  EXPECT_EQ(context().size(), 16 * 5 + 15 * 2u);
  while (!open.empty()) open.pop_back();
}

TEST(CrashNotes, KeepsTheLastOnes) {
  const auto notes = std::make_unique<CrashNotes>();
  EXPECT_THAT(textsOf(*notes), IsEmpty());
  for (int i = 0; i < 40; ++i) notes->add("note " + std::to_string(i));
  const auto texts = textsOf(*notes);
  ASSERT_EQ(texts.size(), 32u);
  EXPECT_EQ(texts.front(), "note 8");
  EXPECT_EQ(texts.back(), "note 39");
}

TEST(CrashNotes, AreOneLineBehindTheirContext) {
  const auto notes = std::make_unique<CrashNotes>();
  const CrashContext process{"Motion", Time{8}}, module{"WalkingEngine"};
  notes->add("step\n4");
  notes->add(std::string(200, 'x'));
  EXPECT_EQ(textsOf(*notes)[0], "Motion at 8 ms, WalkingEngine: step 4");
  EXPECT_EQ(textsOf(*notes)[1], "Motion at 8 ms, WalkingEngine: " + std::string(89, 'x'));
}

}  // namespace
}  // namespace gt
