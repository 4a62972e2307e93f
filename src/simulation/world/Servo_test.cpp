#include "simulation/world/Servo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// Turns a flywheel without load by a servo, with the damping that the engine would add.
double turn(Servo& servo, double& speed, double angle, double seconds, double load = 0) {
  constexpr double step = 0.001, inertia = 0.002;
  for (double t = 0; t < seconds; t += step) {
    const double torque = servo.torque(angle, step) + load;
    speed = (speed + torque / inertia * step) / (1 + servo.gains().d / inertia * step);
    angle += speed * step;
  }
  return angle;
}

TEST(Servo, ReachesItsTargetNotFasterThanItsJointCan) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(Joint::earL); ++j) {
    const auto joint = static_cast<Joint>(j);
    const JointLimits limits = limitsOf(joint);
    const double way = 0.5 * (limits.high - limits.low);
    Servo servo{joint};
    double speed = 0;
    servo.rest(limits.low);
    servo.setTarget(limits.low + way);
    const double half = turn(servo, speed, limits.low, 0.5 * way / limits.speed);
    EXPECT_LE(half, limits.low + 0.5 * way + 0.05) << j;
    const double reached = turn(servo, speed, half, 3);
    EXPECT_NEAR(reached, limits.low + way, 0.02) << j;
    EXPECT_TRUE(servo.atTarget());
  }
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
  double speed = 0;
  servo.rest(0.5);
  servo.setTarget(0.5);
  const double loaded = turn(servo, speed, 0.5, 0.3, -0.4);
  EXPECT_LT(loaded, 0.5 - 0.01);
  EXPECT_GT(loaded, 0.5 - 0.1);
  EXPECT_GT(turn(servo, speed, loaded, 3, -0.4), loaded);  // the integral part works
  EXPECT_LT(servo.torque(-100, 0.001), servo.gains().torque + 1e-12);
}

TEST(Servo, WorksWithOtherGains) {
  const auto sag = [](int p, int i) {
    Servo servo{Joint::legFR3};
    PidGains words = defaultGains(Joint::legFR3);
    EXPECT_FALSE(servo.setGains(words)) << "they are these already";
    words.p = p;
    words.i = i;
    EXPECT_TRUE(servo.setGains(words));
    double speed = 0;
    servo.rest(0.5);
    servo.setTarget(0.5);
    return 0.5 - turn(servo, speed, 0.5, 2, -0.4);
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
  servo.setStrength(0.8);
  servo.setStrength(0.9);
  EXPECT_NEAR(servo.gains().p, 0.9 * full.p, 1e-12);
  EXPECT_NEAR(servo.gains().torque, 0.9 * full.torque, 1e-12);
  servo.rest(0.5);
  EXPECT_NEAR(servo.torque(-100, 0.001), 0.9 * full.torque, 1e-12);
}

}  // namespace
}  // namespace gt
