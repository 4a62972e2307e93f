#include "simulation/world/Servo.h"

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// Sony's words P, I and D in Nm/rad, Nm/(rad s) and Nm s/rad. ESTIMATE, see gainsOf().
constexpr double unitP = 0.27, unitI = 0.4, unitD = 0.012;
constexpr double legTorque = 1.5, otherTorque = 0.6;  // Nm, ESTIMATE

}  // namespace

ServoGains gainsOf(Joint joint, const PidGains& words) {
  const bool ofLeg = joint >= Joint::legFR1 && joint <= Joint::legHL3;
  return {unitP * words.p, unitI * words.i, unitD * words.d, ofLeg ? legTorque : otherTorque};
}

Servo::Servo(Joint joint)
    : joint_(joint), words_(defaultGains(joint)), gains_(gainsOf(joint, words_)) {
  const JointLimits limits = limitsOf(joint);
  low_ = limits.low;
  high_ = limits.high;
  speed_ = limits.speed;
}

bool Servo::setGains(const PidGains& words) {
  if (words == words_) return false;
  words_ = words;
  gains_ = gainsOf(joint_, words_);
  gains_.p *= strength_;
  gains_.torque *= strength_;
  if (words_.i == 0) integral_ = 0;  // nothing would ever take it away
  return true;
}

void Servo::rest(double angle) {
  reference_ = angle;
  integral_ = 0;
}

void Servo::setStrength(double factor) {
  gains_.p *= factor / strength_;
  gains_.torque *= factor / strength_;
  strength_ = factor;
}

void Servo::setTarget(double angle) {
  if (std::isfinite(angle)) target_ = std::clamp(angle, low_, high_);
}

double Servo::turnFreely(double seconds) {
  const double fastest = speed_ * seconds;
  reference_ += std::clamp(target_ - reference_, -fastest, fastest);
  return reference_;
}

double Servo::torque(double angle, double seconds) {
  turnFreely(seconds);
  const double error = reference_ - angle;
  const double wanted = gains_.p * error + integral_;
  // While the motor gives all it can, the integral does not wind up.
  if (std::abs(wanted) < gains_.torque) integral_ += gains_.i * error * seconds;
  return std::clamp(wanted, -gains_.torque, gains_.torque);
}

}  // namespace gt
