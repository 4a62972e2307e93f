#include "simulation/world/Servo.h"

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// The units of Sony's words P, I and D in Nm/rad, Nm/(rad s) and Nm s/rad, and the motors' limits.
/// ESTIMATES: with them, motions that a champion of 2002 played on ERS-210s have their intended
/// effect in the simulator (docs/motion.md).
constexpr double unitP = 0.8, unitI = 0.4, unitD = 0.012;
constexpr double legTorque = 2, otherTorque = 0.6;  // Nm
constexpr double margin = 1.8;  ///< The speed without load as a multiple of what Sony recommends.

}  // namespace

Motor motorOf(Joint joint) {
  return {isOfLeg(joint) ? legTorque : otherTorque, margin * limitsOf(joint).speed};
}

ServoGains gainsOf(const PidGains& words) {
  return {unitP * words.p, unitI * words.i, unitD * words.d};
}

Servo::Servo(Joint joint)
    : words_(defaultGains(joint)), gains_(gainsOf(words_)), motor_(motorOf(joint)) {
  const JointLimits limits = limitsOf(joint);
  low_ = limits.low;
  high_ = limits.high;
}

void Servo::setGains(const PidGains& words) {
  if (words == words_) return;
  words_ = words;
  gains_ = gainsOf(words_);
  gains_.p *= strength_;
  if (words_.i == 0) integral_ = 0;  // nothing would ever take it away
}

void Servo::rest(double angle) {
  free_ = angle;
  integral_ = 0;
}

void Servo::setStrength(double factor) {
  gains_.p *= factor / strength_;
  strength_ = factor;
}

void Servo::setTarget(double angle) {
  if (std::isfinite(angle)) target_ = std::clamp(angle, low_, high_);
}

double Servo::turnFreely(double seconds) {
  const double fastest = motor_.noLoadSpeed * seconds;
  free_ += std::clamp(target_ - free_, -fastest, fastest);
  return free_;
}

Drive Servo::drive(double angle, double speed, double seconds) {
  const double error = target_ - angle;
  const double wanted = gains_.p * error + integral_;
  const double most = strength_ * motor_.stallTorque;
  // Beyond the motor's torque, P and D change nothing, and the integral does not wind up.
  const double withD = wanted - gains_.d * speed;
  if (std::abs(withD) >= most) return {std::copysign(most, withD), motor_.damping()};
  integral_ += gains_.i * error * seconds;
  return {wanted, motor_.damping() + gains_.d};
}

}  // namespace gt
