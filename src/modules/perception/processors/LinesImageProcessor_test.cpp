#include "modules/perception/processors/LinesImageProcessor.h"

#include <gtest/gtest.h>

#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

TEST(LinesImageProcessor, FindsTheSameEdgesAsGT2003AndNothingElse) {
  Random random{5};
  DrawnField scene{-0.2, 0.1};
  scene.draw(fieldAt, 1, 2, random);
  const ColorTable64 table = blackWhiteTable();
  DrawnPercepts own, all;
  own.ball.seen = true;
  own.landmarks.numberOfFlags = own.landmarks.numberOfGoals = 1;
  LinesImageProcessor lines;
  lines.update(scene.image, scene.matrix, table, {}, own, own.debug);
  GT2003ImageProcessor gt2003;
  gt2003.update(scene.image, scene.matrix, table, {}, all, all.debug);
  EXPECT_GT(own.lines.points[EdgeType::line].size(), 10u);
  for (const EdgeType type : {EdgeType::line, EdgeType::border})
    EXPECT_EQ(own.lines.points[type], all.lines.points[type]);
  EXPECT_FALSE(own.ball.seen);
  EXPECT_EQ(own.landmarks.numberOfFlags + own.landmarks.numberOfGoals, 0);
  EXPECT_TRUE(own.obstacles.lines.empty());
  scene.matrix.valid = false;
  lines.update(scene.image, scene.matrix, table, {}, own, own.debug);
  EXPECT_TRUE(own.lines.points[EdgeType::line].empty()) << "lines at unknown places";
}

TEST(LinesImageProcessor, DrawsItsGridAndTheEdgesOnIt) {
  Random random{5};
  DrawnField scene{-0.2, 0.1};
  scene.draw(fieldAt, 1, 2, random);
  DrawnPercepts found;
  LinesImageProcessor lines;
  const auto drawn = [&](std::string_view key, bool on) {
    found.debug.keys().set(*DebugKey::find(key),
                           {on ? DebugKeyMode::always : DebugKeyMode::disabled});
    found.debug.out().clear();
    lines.update(scene.image, scene.matrix, blackWhiteTable(), {}, found, found.debug);
    Drawing drawing;
    found.debug.out().handleAllMessages(
        [&](const Message& message) { EXPECT_TRUE(message.read(drawing)); });
    return drawing.elements;
  };
  const auto grid = drawn("ImageProcessor/grid", true);
  EXPECT_TRUE(drawn("ImageProcessor/grid", false).empty());
  const auto edges = drawn("ImageProcessor/edges", true);
  ASSERT_GT(grid.size(), 10u);
  for (const DrawingElement& element : grid) EXPECT_EQ(element.type, ElementType::line);
  EXPECT_GT(edges.size(), 10u);
  for (const DrawingElement& element : edges) EXPECT_EQ(element.type, ElementType::point);
}

}  // namespace
}  // namespace gt
