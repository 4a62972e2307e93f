#include "modules/modeling/ball/BallChallengeBallLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/BallScene.h"

namespace gt {
namespace {

TEST(BallChallengeBallLocator, AveragesPositionsAndSpeeds) {
  BallScene<BallChallengeBallLocator> scene;
  scene.locator.parameters.positions = 2;
  scene.locator.parameters.speeds = 2;
  scene.ball = {500, 0};
  for (const double noise : {0., 10., 40.}) scene.step({}, {noise, 0});
  EXPECT_DOUBLE_EQ(scene.model.position.x(), 525);
  EXPECT_DOUBLE_EQ(scene.model.speed.x(), (10 + 30) / 0.04 / 2);
}

}  // namespace
}  // namespace gt
