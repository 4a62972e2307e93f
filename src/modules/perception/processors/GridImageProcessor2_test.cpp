#include "modules/perception/processors/GridImageProcessor2.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnBoxes.h"
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
    scene.matrix.valid = false;
    found.lookWith(processor, scene.image, scene.matrix, field);
    EXPECT_TRUE(found.lines.points[EdgeType::line].empty()) << "lines at unknown places";
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

// A tricot of another red than was known before.
TEST(GridImageProcessor2, LearnsTheColorOfTricots) {
  Random random{2};
  const FieldDimensions field;
  const Vector3d from{0, 0, 170}, red{65, 78, 215}, gray{120, 128, 128};
  const Box legs{{600, -60, 0}, {700, 60, 100}, ColorClass::gray};
  const Box tricot{{600, -60, 100}, {700, 60, 190}, ColorClass::red};
  const auto errorWith = [&](bool robot) {
    GridImageProcessor2 processor;
    DrawnPercepts found;
    DrawnField scene;
    scene.draw(
        [&](const Vector3d& ray) {
          return robot && tricot.meets(from, ray) > 0 ? red
                 : robot && legs.meets(from, ray) > 0 ? gray
                                                      : fieldAt(ray);
        },
        1, 2, random);
    for (int i = 0; i < 100; ++i) found.lookWith(processor, scene.image, scene.matrix, field);
    EXPECT_EQ(found.players.players[TeamColor::red].size(), robot);
    const double hue = std::atan2(red[2] - 128, red[1] - 128);
    return std::abs(normalize(processor.colors().tone(ColorClass::red).hue - hue));
  };
  EXPECT_LT(errorWith(true), 0.5 * errorWith(false));
}

}  // namespace
}  // namespace gt
