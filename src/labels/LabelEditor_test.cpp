#include "labels/LabelEditor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "base/TemporaryFolder.h"

namespace gt {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LabelTool tool(const std::string& name) {
  for (const LabelTool& known : labelTools())
    if (known.name == name) return known;
  throw std::out_of_range{name};
}

TEST(LabelEditor, MarksAllThatThereIsAndTakesItBack) {
  LabelEditor editor;
  EXPECT_FALSE(editor.changed());
  editor.draw(3, 700, tool("ball, whole"), {10, 20}, {13, 24});
  EXPECT_EQ(editor.labels().balls.at(3), (BallLabel{3, 700, BallView::whole, {10, 20}, 5}));
  editor.draw(3, 700, tool("field line"), {1, 1}, {1, 1});
  editor.draw(3, 700, tool("field line"), {2, 2}, {2, 2});
  editor.endLine();
  editor.draw(3, 700, tool("field line"), {3, 3}, {3, 3});
  editor.draw(3, 700, tool("flag pinkAboveYellow"), {4, 4}, {9, 9});
  editor.draw(3, 700, tool("player blue"), {4, 4}, {9, 9});
  editor.draw(3, 700, tool("player blue"), {14, 4}, {19, 9});
  EXPECT_THAT(editor.names(3), ElementsAre("ball", "line1", "line2", "flag.pinkAboveYellow",
                                           "player.blue1", "player.blue2"));
  EXPECT_THAT(editor.names(4), IsEmpty());
  EXPECT_TRUE(editor.changed());
  editor.remove(3, "line1");
  editor.remove(3, "no such");
  EXPECT_EQ(editor.labels().fields.at(3).lines.size(), 1u);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.labels().fields.at(3).lines.front().size(), 2u);
  int changes = 0;
  while (editor.undo()) ++changes;
  EXPECT_EQ(changes, 7);
  EXPECT_TRUE(editor.labels().empty());
}

TEST(LabelEditor, AnImageWithoutAnythingIsLabeledToo) {
  LabelEditor editor;
  editor.draw(1, 40, tool("no ball"), {1, 1}, {1, 1});
  editor.draw(1, 40, tool("nothing of the field"), {1, 1}, {1, 1});
  EXPECT_THAT(editor.names(1), ElementsAre("ball", "none"));
  EXPECT_EQ(editor.labels().balls.at(1).view, BallView::none);
  editor.remove(1, "none");
  EXPECT_TRUE(editor.labels().fields.empty());
}

TEST(ImageLabels, AreSavedAndReadWithoutLoss) {
  const TemporaryFolder folder;
  const std::string base = (folder.path() / "log").string();
  LabelEditor editor;
  for (const LabelTool& each : labelTools()) {
    const int picture = each.kind == LabelTool::Kind::nothing ? 7 : 5;
    editor.draw(picture, 123, each, {1.0 / 3, 2e-7}, {1e5 / 7, 33.25});
  }
  ASSERT_TRUE(writeImageLabels(base, editor.labels()));
  auto read = readImageLabels(base);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(*read, editor.labels());
  // A set without balls does not find those of before.
  ImageLabels fields = editor.labels();
  fields.balls.clear();
  ASSERT_TRUE(writeImageLabels(base, fields));
  read = readImageLabels(base);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, fields);
  EXPECT_FALSE(readImageLabels((folder.path() / "other").string()));
}

TEST(ImageLabels, OfTheRealRobotAreKeptWithoutLoss) {
  const auto labels = readImageLabels("tests/real/nao2009");
  ASSERT_TRUE(labels) << labels.error().text();
  EXPECT_EQ(labels->balls.size(), 96u);
  const TemporaryFolder folder;
  const std::string base = (folder.path() / "nao").string();
  ASSERT_TRUE(writeImageLabels(base, *labels));
  const auto again = readImageLabels(base);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(*again, *labels);
}

}  // namespace
}  // namespace gt
