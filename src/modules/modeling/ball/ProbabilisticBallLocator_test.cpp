#include "modules/modeling/ball/ProbabilisticBallLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/BallScene.h"

namespace gt {
namespace {

TEST(ProbabilisticBallLocator, NoticesAKickWithinFourImages) {
  BallScene<ProbabilisticBallLocator> scene;
  scene.ball = {200, 0};
  scene.deceleration = 250;
  for (int i = 0; i < 25; ++i) scene.step();
  EXPECT_LT(scene.model.speed.norm(), 30);
  scene.ballSpeed = {1500, 300};
  for (int i = 0; i < 4; ++i) scene.step();
  EXPECT_LT(scene.error(), 40);
  EXPECT_LT(scene.speedError(), 350);
  for (int i = 0; i < 20; ++i) scene.step();
  EXPECT_LT(scene.speedError(), 60);
  for (int i = 0; i < 10; ++i) scene.step({}, {0, 0}, false);  // It rolls on unseen.
  EXPECT_LT(scene.error(), 80);
  EXPECT_GT(scene.model.standardDeviation, 20) << "and becomes uncertain";
}

TEST(ProbabilisticBallLocator, WrongPerceptsAreNoBallUntilTheyAgree) {
  BallScene<ProbabilisticBallLocator> scene;
  for (int i = 0; i < 25; ++i) scene.step();
  const Time before = scene.frame.time;
  scene.step({}, {-100, 1500});
  EXPECT_LT(scene.error(), 1);
  EXPECT_EQ(scene.model.lastSeen, before);
  scene.step({}, {900, -700});
  EXPECT_LT(scene.error(), 1);
  scene.ball = {300, -1200};
  for (int i = 0; i < 3; ++i) scene.step();
  EXPECT_LT(scene.error(), 10);
}

TEST(ProbabilisticBallLocator, FindsABallAgainThatLayElsewhereForLong) {
  for (const int pictures : {10, 100, 1000}) {
    BallScene<ProbabilisticBallLocator> scene;
    scene.ball = {2500, 400};
    for (int i = 0; i < 25; ++i) scene.step();
    for (int i = 0; i < pictures; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
    scene.ball = scene.odometry.pose * Vector2d{600, -300};
    for (int i = 0; i < 4; ++i) scene.step();
    EXPECT_LT(scene.error(), 20) << pictures;
  }
}

TEST(ProbabilisticBallLocator, ABallThatShouldBeSeenAndIsNotGivesWay) {
  const auto steps = [](bool looksThere) {
    BallScene<ProbabilisticBallLocator> scene;
    for (int i = 0; i < 25; ++i) scene.step();
    scene.step({}, {0, -900});  // Perhaps it is elsewhere.
    scene.camera.valid = looksThere;
    scene.camera.pose = {rotationY(0.25), {100, 0, 200}};
    int n = 0;
    while (scene.error() < 100 && n < 100) {
      scene.step({}, {0, 0}, false);
      ++n;
    }
    return n;
  };
  EXPECT_LT(steps(true), 40);
  EXPECT_EQ(steps(false), 100);
}

}  // namespace
}  // namespace gt
