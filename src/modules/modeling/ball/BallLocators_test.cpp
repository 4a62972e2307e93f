// What all ball locators have in common.
#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/modeling/ball/BallChallengeBallLocator.h"
#include "modules/modeling/ball/PIDSmoothedBallLocator.h"
#include "modules/modeling/ball/ProbabilisticBallLocator.h"
#include "modules/modeling/testing/BallScene.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

template <typename Locator>
class BallLocators : public ::testing::Test {};
using Locators = ::testing::Types<BallChallengeBallLocator, ProbabilisticBallLocator>;
TYPED_TEST_SUITE(BallLocators, Locators);

template <typename Locator>
class AllBallLocators : public ::testing::Test {};
using AllLocators =
    ::testing::Types<BallChallengeBallLocator, PIDSmoothedBallLocator, ProbabilisticBallLocator>;
TYPED_TEST_SUITE(AllBallLocators, AllLocators);

TYPED_TEST(BallLocators, ABallNeverSeenWasNeverSeen) {
  BallScene<TypeParam> scene;
  scene.step({}, {0, 0}, false);
  EXPECT_EQ(scene.model.lastSeen, never());
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
}

// Report 3.4.2: seen, not perceived for a short time, not seen for some time.
TYPED_TEST(BallLocators, TellWhichOfTheThreeSituationsHolds) {
  BallScene<TypeParam> scene;
  for (int i = 0; i < 26; ++i) scene.step();
  EXPECT_EQ(scene.model.lastSeen, scene.frame.time);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1000);
  const Time last = scene.frame.time;
  for (int i = 0; i < 3; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
  EXPECT_EQ(scene.model.lastSeen, last);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1000) << "a short period of time";
  EXPECT_LT(scene.error(), 10) << "odometry corrects the position";
  scene.step();
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1160);
  for (int i = 0; i < 50; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
  EXPECT_LT(scene.error(), 10);
}

TYPED_TEST(BallLocators, FindTheSpeedOfARollingBallWhileTheRobotWalks) {
  Random random{3};
  BallScene<TypeParam> scene;
  scene.ball = {600, -400};
  scene.ballSpeed = {150, 250};
  scene.deceleration = 50;
  double position = 0, speed = 0;
  for (int i = 0; i < 60; ++i) {
    scene.step({0.02, 6, 2}, {8 * random.gaussian(), 8 * random.gaussian()});
    if (i < 30) continue;
    position += scene.error() / 30;
    speed += scene.speedError() / 30;
  }
  EXPECT_LT(position, 30);
  EXPECT_LT(speed, 120);
}

TYPED_TEST(AllBallLocators, StopABallThatReachesTheRobot) {
  BallScene<TypeParam> scene;
  scene.ball = {1200, 80};
  scene.ballSpeed = {-1000, 0};
  while (scene.ball.x() > 250) scene.step();
  for (int i = 0; i < 25; ++i) scene.step({}, {0, 0}, false);
  EXPECT_GT(scene.model.position.x(), 50);
  EXPECT_LT(scene.model.position.norm(), 350);
}

TYPED_TEST(BallLocators, SmoothNoise) {
  Random random{4};
  BallScene<TypeParam> scene;
  double raw = 0, smoothed = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector2d noise{30 * random.gaussian(), 15 * random.gaussian()};
    scene.step({}, noise);
    raw += noise.norm();
    smoothed += scene.error();
  }
  EXPECT_LT(smoothed, 0.7 * raw);
}

TYPED_TEST(BallLocators, AllocateNothing) {
  BallScene<TypeParam> scene;
  for (int i = 0; i < 10; ++i) scene.step();
  const auto before = allocations();
  for (int i = 0; i < 10; ++i) scene.step({0.02, 6, 2}, {i * 30., 0}, i % 3 != 0);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace gt
