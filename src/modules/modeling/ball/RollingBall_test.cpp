#include "modules/modeling/ball/RollingBall.h"

#include <gtest/gtest.h>

#include "base/NumericJacobian.h"

namespace gt {
namespace {

constexpr RollingBall ball{250};
using State = RollingBall::State;

TEST(RollingBall, RollsUntilItRests) {
  EXPECT_LT((ball.after(2, State{100, 0, 600, 800}) - State{1000, 1200, 300, 400}).norm(), 1e-9);
  for (const double seconds : {4., 10.})
    EXPECT_LT((ball.after(seconds, State{100, 0, 600, 800}) - State{1300, 1600, 0, 0}).norm(),
              1e-9);
  EXPECT_EQ(ball.after(1, State{100, 50, 0, 0}), (State{100, 50, 0, 0}));
}

TEST(RollingBall, ItsDerivativeIsThatOfItsMotion) {
  const State steps = State::Constant(1e-3);
  // It rolls, rolls slowly, comes to rest meanwhile.
  for (const State& state : {State{100, -50, 600, 800}, State{0, 0, -20, 3}, State{5, 6, 4, -7}}) {
    const auto numeric =
        numericJacobian([](const State& s) { return ball.after(0.04, s); }, state, steps);
    EXPECT_LT((ball.derivative(0.04, state) - numeric).norm(), 1e-6) << state.transpose();
  }
}

TEST(RollingBall, ASpeedThatIsNotKnownMayBeAny) {
  const auto derivative = ball.derivative(0.04, State::Zero());
  EXPECT_EQ(derivative(0, 2), 0.04);
  EXPECT_EQ(derivative(3, 3), 1);
}

}  // namespace
}  // namespace gt
