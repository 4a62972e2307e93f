#include "simulation/world/Servo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// A flywheel that a servo turns, with the damping that the engine would add.
struct Flywheel {
  double angle;
  double speed = 0;
  double fastest = 0;

  void turn(Servo& servo, double seconds, double load = 0) {
    constexpr double step = 0.001, inertia = 0.002;
    for (double t = 0; t < seconds; t += step) {
      const Drive drive = servo.drive(angle, speed, step);
      speed =
          (speed + (drive.torque + load) / inertia * step) / (1 + drive.damping / inertia * step);
      angle += speed * step;
      fastest = std::max(fastest, std::abs(speed));
    }
  }
};

TEST(Servo, ReachesItsTargetNotFasterThanItsMotorCan) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(Joint::earL); ++j) {
    const auto joint = static_cast<Joint>(j);
    const JointLimits limits = limitsOf(joint);
    const double way = 0.5 * (limits.high - limits.low);
    Servo servo{joint};
    servo.rest(limits.low);
    servo.setTarget(limits.low + way);
    Flywheel wheel{limits.low};
    wheel.turn(servo, 0.5 * way / motorOf(joint).noLoadSpeed);
    EXPECT_LE(wheel.angle, limits.low + 0.5 * way + 0.05) << j;
    wheel.turn(servo, 3);
    EXPECT_NEAR(wheel.angle, limits.low + way, 0.02) << j;
    EXPECT_LE(wheel.fastest, motorOf(joint).noLoadSpeed) << j;
  }
}

// A recommendation is no limit: 172 degrees of the head's pan within 0.4 s were a champion's kick.
TEST(Servo, TurnsFasterThanSonyRecommends) {
  Servo servo{Joint::headPan};
  servo.setTarget(1.5);
  Flywheel wheel{-1.5};
  wheel.turn(servo, 0.7);
  EXPECT_GT(wheel.angle, 1.4);
  EXPECT_GT(wheel.fastest, 1.5 * limitsOf(Joint::headPan).speed);
}

TEST(Servo, IsSlowerTheMoreItHasToLift) {
  const auto fastest = [](double share) {
    Servo servo{Joint::legFR2};
    servo.setTarget(limitsOf(Joint::legFR2).high);
    Flywheel wheel{limitsOf(Joint::legFR2).low};
    wheel.turn(servo, 0.3, -share * motorOf(Joint::legFR2).stallTorque);
    return wheel.speed / motorOf(Joint::legFR2).noLoadSpeed;
  };
  EXPECT_NEAR(fastest(0), 1, 0.02);
  EXPECT_NEAR(fastest(0.5), 0.5, 0.02);
  EXPECT_LT(fastest(1.1), 0);
}

TEST(Servo, FollowsAsItsLagSays) {
  Servo servo{Joint::legFR1};
  Flywheel wheel{0};
  double target = 0;
  constexpr double pace = 1;  // rad/s
  for (int i = 0; i < 500; ++i) {
    servo.setTarget(target += 0.001 * pace);
    wheel.turn(servo, 0.001);
  }
  EXPECT_NEAR(target - wheel.angle, pace * servo.lag(), 0.1 * pace * servo.lag());
}

TEST(Servo, KeepsItsLimitsAndIgnoresWhatIsNoNumber) {
  Servo servo{Joint::headTilt};
  servo.rest(0);
  servo.setTarget(100);
  for (int i = 0; i < 200; ++i) servo.turnFreely(0.01);
  EXPECT_EQ(servo.turnFreely(0.01), limitsOf(Joint::headTilt).high);
  servo.setTarget(std::nan(""));
  EXPECT_EQ(servo.turnFreely(0.01), limitsOf(Joint::headTilt).high);
}

TEST(Servo, GivesWayToALoadAndComesBack) {
  Servo servo{Joint::legFR3};
  servo.rest(0.5);
  servo.setTarget(0.5);
  Flywheel wheel{0.5};
  wheel.turn(servo, 0.3, -0.4);
  const double loaded = wheel.angle;
  EXPECT_LT(loaded, 0.5 - 0.005);
  EXPECT_GT(loaded, 0.5 - 0.1);
  wheel.turn(servo, 3, -0.4);
  EXPECT_GT(wheel.angle, loaded) << "the integral part works";
  EXPECT_EQ(servo.drive(-100, 0, 0.001).torque, motorOf(Joint::legFR3).stallTorque);
}

TEST(Servo, WorksWithOtherGains) {
  const auto sag = [](int p, int i) {
    Servo servo{Joint::legFR3};
    PidGains words = defaultGains(Joint::legFR3);
    words.p = p;
    words.i = i;
    servo.setGains(words);
    servo.rest(0.5);
    servo.setTarget(0.5);
    Flywheel wheel{0.5};
    wheel.turn(servo, 2, -0.4);
    return 0.5 - wheel.angle;
  };
  EXPECT_NEAR(sag(20, 0), 2 * sag(40, 0), 0.001);
  EXPECT_LT(sag(20, 40), sag(20, 0) / 2) << "the integral part works";
  Servo weak{Joint::legFR3};
  weak.setStrength(0.8);
  weak.setGains({100, 0, 0});
  Servo strong{Joint::legFR3};
  strong.setGains({100, 0, 0});
  EXPECT_NEAR(weak.gains().p, 0.8 * strong.gains().p, 1e-12);
}

TEST(Servo, IsAsStrongAsItsBattery) {
  Servo servo{Joint::legFR3};
  const ServoGains full = servo.gains();
  const double most = servo.drive(-100, 0, 0.001).torque;
  servo.setStrength(0.8);
  servo.setStrength(0.9);
  EXPECT_NEAR(servo.gains().p, 0.9 * full.p, 1e-12);
  EXPECT_NEAR(servo.drive(-100, 0, 0.001).torque, 0.9 * most, 1e-12);
}

}  // namespace
}  // namespace gt
