#include "simulation/world/Servo.h"

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// Sony's words P, I and D in Nm/rad, Nm/(rad s) and Nm s/rad. ESTIMATE, see gainsOf().
constexpr double unitP = 0.27, unitI = 0.4, unitD = 0.012;
constexpr double legTorque = 1.5, otherTorque = 0.6;  // Nm, ESTIMATE

constexpr ServoGains fromWords(int p, int i, int d, double torque) {
  return {unitP * p, unitI * i, unitD * d, torque};
}

}  // namespace

ServoGains gainsOf(Joint joint) {
  switch (joint) {
    case Joint::headTilt:
    case Joint::headRoll:
      return fromWords(0x0a, 0x08, 0x0c, otherTorque);
    case Joint::headPan:
      return fromWords(0x0d, 0x08, 0x0b, otherTorque);
    case Joint::mouth:
      return fromWords(0x0e, 0x08, 0x10, otherTorque);
    case Joint::tailPan:
      return fromWords(0x0a, 0x00, 0x18, otherTorque);
    case Joint::tailTilt:
    case Joint::earL:
    case Joint::earR:
      return fromWords(0x07, 0x00, 0x11, otherTorque);
    default:
      break;
  }
  switch ((static_cast<int>(joint) - static_cast<int>(Joint::legFR1)) % 3) {
    case 0:
      return fromWords(0x16, 0x04, 0x08, legTorque);
    case 1:
      return fromWords(0x14, 0x04, 0x06, legTorque);
    default:
      return fromWords(0x23, 0x04, 0x05, legTorque);
  }
}

Servo::Servo(Joint joint) : gains_(gainsOf(joint)) {
  const JointLimits limits = limitsOf(joint);
  low_ = limits.low;
  high_ = limits.high;
  speed_ = limits.speed;
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
