#include "modules/behavior/tactics/RollingBall.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

BallModel rolling(const Vector2d& position, const Vector2d& speed) {
  BallModel ball;
  ball.position = position;
  ball.speed = speed;
  return ball;
}

TEST(RollingBall, CrossesTheRobotsLineWhereAndWhenItRollsThere) {
  const auto crossing = crossingOf(rolling({1000, 300}, {-500, -100}), 0);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->left, 100, 1e-9);
  EXPECT_NEAR(crossing->time, 2000, 1e-9);
}

// Compared with the ball rolled in small steps.
TEST(RollingBall, LosesSpeedOnItsWay) {
  constexpr double deceleration = 250, step = 1e-4;
  Vector2d place{800, -200}, speed{-900, 300};
  const auto crossing = crossingOf(rolling(place, speed), deceleration);
  double seconds = 0;
  for (; place.x() > 0; seconds += step) {
    place += speed * step;
    speed -= speed.normalized() * deceleration * step;
  }
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->left, place.y(), 0.5);
  EXPECT_NEAR(crossing->time, 1000 * seconds, 0.5);
}

TEST(RollingBall, DoesNotCrossIfItStopsBeforeOrRollsElsewhere) {
  EXPECT_TRUE(crossingOf(rolling({300, 0}, {-400, 0}), 250));
  EXPECT_FALSE(crossingOf(rolling({350, 0}, {-400, 0}), 250));
  EXPECT_FALSE(crossingOf(rolling({300, 0}, {400, 0}), 250));
  EXPECT_FALSE(crossingOf(rolling({-300, 0}, {-400, 0}), 250)) << "it is behind";
  EXPECT_FALSE(crossingOf(rolling({300, 0}, {0, 0}), 0));
}

}  // namespace
}  // namespace gt
