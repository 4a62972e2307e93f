#include "modules/motion/walking/Balance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gt {
namespace {

constexpr int stepLen = 30;

/// A walk whose body sways and whose legs lag alike in each step.
struct Steps {
  BalanceParameters parameters{.memory = 0.3, .threshold = 50, .stumble = 0.2};
  Balance balance;
  SensorData measured;
  JointAngles asked;
  int frame = 0;

  void step(const Vector2d& pushed = {0, 0}, double held = 0) {
    const double phase = 2 * pi * frame / stepLen;
    measured.acceleration = {2000 * std::sin(phase) + pushed.x(),
                             3000 * std::cos(phase) + pushed.y(), 9810};
    asked[Joint::legFL1] = 0.3 * std::sin(phase);
    measured.joints[Joint::legFL1] = 0.2 * std::sin(phase - 0.5) - held;
    balance.update(parameters, measured, asked, frame, stepLen);
    frame = (frame + 1) % stepLen;
  }
  void cycles(int n) {
    for (int i = 0; i < n * stepLen; ++i) step();
  }
};

TEST(Balance, TakesTheSwayOfEachStepForNoPush) {
  Steps walk;
  for (int i = 0; i < 10 * stepLen; ++i) {
    walk.step();
    EXPECT_EQ(walk.balance.unexpectedSpeed(), Vector2d(0, 0));
    EXPECT_FALSE(walk.balance.stumbles(Leg::foreLeft));
  }
}

TEST(Balance, FindsTheSpeedOfAPushAndForgetsIt) {
  Steps walk;
  walk.cycles(5);
  for (int i = 0; i < 5; ++i) walk.step({0, 10000});  // 400 mm/s in 40 ms
  EXPECT_NEAR(walk.balance.unexpectedSpeed().y(), 400 - 50, 50);
  EXPECT_NEAR(walk.balance.unexpectedSpeed().x(), 0, 20);
  walk.cycles(4);
  EXPECT_EQ(walk.balance.unexpectedSpeed(), Vector2d(0, 0));
}

TEST(Balance, FindsTheLegThatIsHeldBack) {
  Steps walk;
  walk.cycles(5);
  walk.step({0, 0}, 0.3);
  EXPECT_TRUE(walk.balance.stumbles(Leg::foreLeft));
  EXPECT_FALSE(walk.balance.stumbles(Leg::hindLeft));
  walk.step();
  EXPECT_FALSE(walk.balance.stumbles(Leg::foreLeft));
}

TEST(Balance, KnowsNothingOfAnotherWalk) {
  Steps walk;
  walk.cycles(5);
  walk.balance.forget();
  walk.step({0, 10000}, 1);
  EXPECT_EQ(walk.balance.unexpectedSpeed(), Vector2d(0, 0));
  EXPECT_FALSE(walk.balance.stumbles(Leg::foreLeft));
}

}  // namespace
}  // namespace gt
