#include "modules/modeling/ball/PIDSmoothedBallLocator.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/modeling/testing/BallScene.h"

namespace gt {
namespace {

using Scene = BallScene<PIDSmoothedBallLocator>;
const Pose2D standing{}, walking{0.02, 6, 2};

TEST(PIDSmoothedBallLocator, ABallNeverSeenWasNeverSeen) {
  Scene scene;
  scene.step(standing, {0, 0}, false);
  EXPECT_EQ(scene.model.lastSeen, never());
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
}

TEST(PIDSmoothedBallLocator, TheFirstPerceptIsTakenAsItIs) {
  Scene scene;
  scene.step(standing);
  EXPECT_EQ(scene.model.position, scene.truth());
  EXPECT_EQ(scene.model.lastSeen, scene.frame.time);
}

TEST(PIDSmoothedBallLocator, OdometryMovesAnUnseenBallExactly) {
  Scene scene;
  scene.step(standing);
  for (int i = 0; i < 200; ++i) scene.step(walking, {0, 0}, false);
  EXPECT_LT(scene.error(), 1e-6);
  EXPECT_EQ(scene.model.lastSeen, scene.frame.time - 200 * 40);
}

TEST(PIDSmoothedBallLocator, SpeedConvergesWhileTheRobotWalksAndTurns) {
  Scene scene;
  scene.locator.parameters.slowDown = 0;
  scene.ballSpeed = {150, -120};
  for (int i = 0; i < 75; ++i) scene.step(walking);
  EXPECT_LT(scene.speedError(), 5);
  EXPECT_LT(scene.error(), 5);
}

TEST(PIDSmoothedBallLocator, SpeedOfARestingBallIsZeroHoweverTheRobotMoves) {
  Scene scene;
  for (int i = 0; i < 100; ++i) scene.step(walking);
  EXPECT_LT(scene.model.speed.norm(), 1e-6);
}

TEST(PIDSmoothedBallLocator, SmoothsNoise) {
  double raw = 0, smoothed = 0, speed = 0;
  int n = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random{seed};
    Scene scene;
    for (int i = 0; i < 500; ++i) {
      const double away = 30 * random.gaussian(), aside = 15 * random.gaussian();
      scene.step(standing, {away, aside});
      if (i < 50) continue;
      raw += std::hypot(away, aside);
      smoothed += scene.error();
      speed += scene.model.speed.norm();
      ++n;
    }
  }
  EXPECT_LT(smoothed, 0.7 * raw);
  EXPECT_LT(speed / n, 160);  // From image to image the noise alone makes 1200 mm/s.
}

TEST(PIDSmoothedBallLocator, NoticesAKick) {
  Scene scene;
  scene.ball = {200, 0};
  for (int i = 0; i < 25; ++i) scene.step(standing);
  scene.ballSpeed = {1000, 0};
  for (int i = 0; i < 12; ++i) scene.step(standing);
  EXPECT_GT(scene.model.speed.x(), 500);
  EXPECT_LT(scene.error(), 200);
}

TEST(PIDSmoothedBallLocator, KnowsWithinAFifthOfASecondThatABallRolls) {
  for (const Vector2d& speed : {Vector2d{-1200, -200}, Vector2d{-400, 600}, Vector2d{900, 100}}) {
    Scene scene;
    scene.deceleration = 250;
    scene.ball = {800, 100};
    for (int i = 0; i < 25; ++i) scene.step(standing);
    scene.ballSpeed = speed;
    for (int i = 0; i < 5; ++i) scene.step(standing);
    EXPECT_LT(scene.speedError(), 0.4 * scene.trueSpeed().norm()) << speed.transpose();
  }
}

TEST(PIDSmoothedBallLocator, OneWrongPerceptChangesNothing) {
  Scene scene;
  for (int i = 0; i < 25; ++i) scene.step(standing);
  const Time before = scene.frame.time;
  scene.step(standing, {-100, 1500});
  EXPECT_LT(scene.error(), 1);
  EXPECT_EQ(scene.model.lastSeen, before);
  scene.step(standing);
  EXPECT_LT(scene.error(), 1);
}

TEST(PIDSmoothedBallLocator, SeveralPerceptsElsewhereAreBelieved) {
  Scene scene;
  for (int i = 0; i < 25; ++i) scene.step(standing);
  scene.ball = {300, -1200};
  for (int i = 0; i < scene.locator.parameters.outliersBelieved; ++i) scene.step(standing);
  EXPECT_LT(scene.error(), 1);
  EXPECT_EQ(scene.model.lastSeen, scene.frame.time);
}

TEST(PIDSmoothedBallLocator, WrongPerceptsAtDifferentPlacesAreNotBelieved) {
  Scene scene;
  for (int i = 0; i < 25; ++i) scene.step(standing);
  for (int i = 0; i < 6; ++i) scene.step(standing, {0, i % 2 == 0 ? 1500.0 : -1500.0});
  EXPECT_LT(scene.error(), 1);
}

TEST(PIDSmoothedBallLocator, AfterALongTimeThePerceptIsBelievedAtOnce) {
  Scene scene;
  for (int i = 0; i < 25; ++i) scene.step(standing);
  for (int i = 0; i < 100; ++i) scene.step(standing, {0, 0}, false);
  scene.ball = {300, -1200};
  scene.step(standing);
  EXPECT_EQ(scene.model.position, scene.truth());
}

TEST(PIDSmoothedBallLocator, ConsecutiveTimeSeenForgivesShortGaps) {
  Scene scene;
  for (int i = 0; i < 26; ++i) scene.step(standing);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1000);
  for (int i = 0; i < 3; ++i) scene.step(standing, {0, 0}, false);
  scene.step(standing);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1160);
  for (int i = 0; i < 10; ++i) scene.step(standing, {0, 0}, false);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
  scene.step(standing);
  scene.step(standing);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 40);
}

// A small error of the camera's tilt is a large one of a far ball's distance, not of its direction.
TEST(PIDSmoothedBallLocator, DoubtsTheDistanceOfAFarBallButNotItsDirection) {
  const auto followed = [](double distance, const Vector2d& moved) {
    Scene scene;
    scene.ball = {distance, 0};
    for (int i = 0; i < 20; ++i) scene.step(standing);
    const Vector2d before = scene.model.position;
    scene.step(standing, moved);
    return (scene.model.position - before).norm() / moved.norm();
  };
  EXPECT_LT(followed(2500, {100, 0}), 0.5 * followed(2500, {0, 100}));
  EXPECT_GT(followed(300, {50, 0}), 0.8 * followed(300, {0, 50}));
}

}  // namespace
}  // namespace gt
