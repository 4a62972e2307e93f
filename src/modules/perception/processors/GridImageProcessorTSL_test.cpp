#include "modules/perception/processors/GridImageProcessorTSL.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

TEST(GridImageProcessorTSL, FollowsItsThresholds) {
  Random random{6};
  DrawnField scene{-0.2};
  scene.draw(fieldAt, 1, 0, random);
  DrawnPercepts percepts;
  GridImageProcessorTSL processor;
  TslColors colors;
  const auto seen = [&] {
    processor.update(scene.image, scene.matrix, colors, {}, percepts, percepts.debug);
    return percepts.lines.points[EdgeType::line].size();
  };
  EXPECT_EQ(seen(), 0u) << "without any class";
  const Tsl ground = tslOf(pixelOf(fieldGreen, 0, random));
  const auto around = [](int value) {
    return ColorRange{std::max(value - 40, 0), std::min(value + 40, 255)};
  };
  colors.classes[ColorClass::green].tint = around(ground.tint);
  colors.classes[ColorClass::green].saturation = around(ground.saturation);
  colors.classes[ColorClass::green].luminance = {20, 150};
  colors.classes[ColorClass::white].priority = 1;
  colors.classes[ColorClass::white].saturation = {0, 255};
  colors.classes[ColorClass::white].luminance = {180, 255};
  EXPECT_GT(seen(), 10u);
  scene.matrix.valid = false;
  EXPECT_EQ(seen(), 0u) << "at unknown places";
}

}  // namespace
}  // namespace gt
