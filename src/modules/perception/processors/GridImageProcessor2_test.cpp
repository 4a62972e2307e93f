#include "modules/perception/processors/GridImageProcessor2.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

TEST(GridImageProcessor2, FindsLinesInAnyLightOnceItKnowsTheCarpet) {
  Random random{2};
  const FieldDimensions field;
  for (const double light : {1.0, 0.6}) {
    GridImageProcessor2 processor;
    DrawnPercepts found;
    DrawnField scene;
    scene.draw(fieldAt, light, 2, random);
    found.lookWith(processor, scene.image, scene.matrix, field);
    EXPECT_TRUE(found.lines.points[EdgeType::line].empty());
    for (int i = 0; i < 60; ++i) found.lookWith(processor, scene.image, scene.matrix, field);
    EXPECT_TRUE(processor.colors().isGreenKnown());
    EXPECT_GT(found.lines.points[EdgeType::line].size(), 10u) << "in light " << light;
  }
}

TEST(GridImageProcessor2, DrawsWhatItLearnsOnlyIfSomebodyWatches) {
  Random random{2};
  const FieldDimensions field;
  GridImageProcessor2 processor;
  DrawnPercepts found;
  DrawnField scene;
  const Vector3d ball{500, 0, field.ballRadius}, orange{129, 59, 214};
  scene.draw(
      [&](const Vector3d& ray) {
        const Vector3d to = ball - scene.matrix.pose.translation;
        return (to - ray * to.dot(ray)).norm() < field.ballRadius ? orange : fieldAt(ray);
      },
      1, 2, random);
  for (int i = 0; i < 60; ++i) found.lookWith(processor, scene.image, scene.matrix, field);
  ASSERT_TRUE(found.ball.seen);
  EXPECT_TRUE(found.debug.out().empty());
  found.debug.keys().set(*DebugKey::find("ImageProcessor/adaptation/learned"),
                         {DebugKeyMode::always});
  found.lookWith(processor, scene.image, scene.matrix, field);
  Drawing drawing;
  found.debug.out().handleAllMessages(
      [&](const Message& message) { EXPECT_TRUE(message.read(drawing)); });
  EXPECT_GT(drawing.elements.size(), 5u);
}

}  // namespace
}  // namespace gt
