#include "modules/motion/walking/Balance.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/Tasks.h"

namespace gt {
namespace {

constexpr int learned = 3;        // cycles after which the means are good enough
constexpr double learning = 0.1;  // share of a new cycle in the means
constexpr double sway = 1000;     // mm/s^2: of what differs by more no more is learned
constexpr std::array legs{Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft};

}  // namespace

void Balance::forget() {
  cycle_.clear();
  speed_ = Vector2d::Zero();
  stumbles_ = {};
}

void Balance::update(const BalanceParameters& parameters, const SensorData& measured,
                     const JointAngles& asked, int frame, int stepLen) {
  if (cycle_.size() != static_cast<std::size_t>(stepLen)) {
    forget();
    cycle_.resize(static_cast<std::size_t>(stepLen));
  }
  Expected& expected = cycle_[static_cast<std::size_t>(frame)];
  const bool known = expected.cycles >= learned;
  const double share = std::max(learning, 1. / ++expected.cycles);
  const Vector2d unexpected = measured.acceleration.head<2>() - expected.acceleration;
  // A push is no habit.
  expected.acceleration += share * (known ? unexpected.cwiseMax(-sway).cwiseMin(sway) : unexpected);
  threshold_ = parameters.threshold;
  speed_ *= std::exp(-frameTime / parameters.memory);
  if (known) speed_ += unexpected * frameTime;
  for (const Leg leg : legs) {
    const Joint joint = legJoint(leg, 1);
    const double lag = asked[joint] - measured.joints[joint] - expected.lag[leg];
    expected.lag[leg] += share * lag;
    stumbles_[leg] = known && std::abs(lag) > parameters.stumble;
  }
}

Vector2d Balance::unexpectedSpeed() const {
  const double speed = speed_.norm();
  return speed > threshold_ ? Vector2d{speed_ * (1 - threshold_ / speed)} : Vector2d{0, 0};
}

}  // namespace gt
