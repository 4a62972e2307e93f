#include "modules/behavior/control/ObstacleAvoiderOnGreenField.h"

#include <gtest/gtest.h>

#include <memory>

namespace gt {
namespace {

/// Images of two colors: the ground and what stands on it.
class ObstacleAvoiderTest : public ::testing::Test {
 protected:
  static constexpr Pixel ground{100, 90, 90}, other{200, 128, 128};

  ObstacleAvoiderTest() {
    colors->classes[ColorTable64::index(ground.y, ground.cb, ground.cr)] = ColorClass::green;
    image.allocate();
    fill(0, image.info.width, 0);
  }
  /// Green from the bottom up to a share of the image, in columns.
  void fill(int from, int to, double top) {
    for (int y = 0; y < image.info.height; ++y)
      for (int x = from; x < to; ++x)
        image.at(x, y) = y >= image.info.height * (1 - top) ? ground : other;
  }
  void look() {
    frame.time = frame.time + 40;
    avoider.update(image, *colors, frame, motion, head, leds, sound, debug);
  }

  ObstacleAvoiderOnGreenField avoider;
  std::unique_ptr<ColorTable64> colors = std::make_unique<ColorTable64>();
  Image image;
  FrameInfo frame;
  MotionRequest motion;
  HeadMotionRequest head;
  LedRequest leds;
  SoundRequest sound;
  Debug debug;
};

TEST_F(ObstacleAvoiderTest, WalksWhereAllIsGreen) {
  fill(0, image.info.width, 0.9);
  look();
  EXPECT_EQ(motion.type, MotionType::walk);
  EXPECT_DOUBLE_EQ(motion.walk.translation.x(), avoider.parameters.forward);
  EXPECT_NEAR(motion.walk.rotation, 0, 1e-9);
  EXPECT_EQ(motion.time, frame.time);
  EXPECT_DOUBLE_EQ(head.tilt, fromDegrees(avoider.parameters.headTilt));
}

TEST_F(ObstacleAvoiderTest, TurnsToTheGreenerSide) {
  fill(0, image.info.width / 2, 0.9);
  fill(image.info.width / 2, image.info.width, 0.5);
  look();
  EXPECT_GT(motion.walk.rotation, 0);
  EXPECT_GT(motion.walk.translation.x(), 0);
  EXPECT_LT(motion.walk.translation.x(), avoider.parameters.forward);
}

TEST_F(ObstacleAvoiderTest, TurnsOnTheSpotToOneSideWhileItIsBlocked) {
  fill(image.info.width / 2, image.info.width, 0.15);
  look();
  EXPECT_DOUBLE_EQ(motion.walk.translation.norm(), 0);
  EXPECT_DOUBLE_EQ(motion.walk.rotation, -fromDegrees(avoider.parameters.turn));
  fill(0, image.info.width / 2, 0.2);
  look();
  EXPECT_LT(motion.walk.rotation, 0) << "does not turn to and fro";
}

TEST_F(ObstacleAvoiderTest, FewPixelsOfAnotherColorEndNoGreen) {
  fill(0, image.info.width, 0.9);
  for (int x = 0; x < image.info.width; ++x) image.at(x, 100) = other;
  look();
  EXPECT_DOUBLE_EQ(motion.walk.translation.x(), avoider.parameters.forward);
}

TEST_F(ObstacleAvoiderTest, StandsWithoutAnImage) {
  image.pixels.clear();
  look();
  EXPECT_EQ(motion.type, MotionType::stand);
}

}  // namespace
}  // namespace gt
